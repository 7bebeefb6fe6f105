#pragma once

#include <span>

#include "sim/studies/compare/measure.h"

namespace csgsim::studies {

/// Prints what bounds each machine in its own picture, what the dearest primitives take of each, and what the compared
/// rows say helps most.
void print_compare_words(std::span<const ComparisonRow> rows);

}  // namespace csgsim::studies
