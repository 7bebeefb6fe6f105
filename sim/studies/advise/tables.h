#pragma once

#include <span>
#include <string>

#include "sim/studies/advise/measure.h"

namespace csgsim::studies {

/// What was searched, and what is wished. `subject` is the model's name, with the machine's.
void print_question(const std::string& subject, std::span<const AdviceRow> rows, const Wishes& wishes);

/// The front, on standard output: the part of it with colours as wished, and of a long one what is nearest to the
/// wishes.
void print_front(std::span<const AdviceRow> rows, const Wishes& wishes);

/// What is recommended, with the commands that draw it; and, where nothing meets all wishes, what is in the way and how
/// far the nearest choice is.
void print_advice(const Advice& advice, const Wishes& wishes);

/// `6 bits too many, 2.3 frames a second too few`: all wishes that the choice misses.
std::string misses_text(const AdviceRow& row, const Wishes& wishes);

}  // namespace csgsim::studies
