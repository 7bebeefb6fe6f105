#pragma once

#include <span>
#include <string>

#include "sim/plots/plot.h"
#include "sim/studies/advise/advice.h"

namespace csgsim::studies {

/// What was searched, and what is wished. `subject` is the model's name, with the machine's.
void print_question(const std::string& subject, std::span<const AdviceRow> rows, const Wishes& wishes);

/// The front, on standard output: the part of it with colours as wished, and of a long one what is nearest to the
/// wishes.
void print_front(std::span<const AdviceRow> rows, const Wishes& wishes);

/// What is recommended, with the commands that draw it; and, where nothing meets all wishes, what is in the way and how
/// far the nearest choice is.
void print_advice(const Advice& advice, const Wishes& wishes);

/// A file of advice: wishes, what is recommended, the front and all points.
std::string advice_json(const std::string& title, const Wishes& wishes, std::span<const AdviceRow> rows,
                        const Advice& advice);

/// `6 bits too many, 2.3 frames a second too few`: all wishes that the choice misses.
std::string misses_text(const AdviceRow& row, const Wishes& wishes);

/// What memory bits buy: the most frames a second against memory bits a pixel, a staircase for each limit of wrong
/// pixels, with the wishes and what is recommended.
plots::Plot plot_of_advice(std::span<const AdviceRow> rows, const Wishes& wishes,
                           std::span<const Recommendation> recommendations, const std::string& model);

}  // namespace csgsim::studies
