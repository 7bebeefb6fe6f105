#pragma once

#include <span>

#include "sim/study/comparison.h"

namespace csgsim::app {

/// Prints what bounds each machine in its own picture, what the dearest primitives take of each, and what the compared
/// rows say helps most.
void print_compare_words(std::span<const study::ComparisonRow> rows);

}  // namespace csgsim::app
