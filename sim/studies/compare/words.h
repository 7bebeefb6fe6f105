// Summary of a comparison in words.
// Used by csgsim compare.
#pragma once

#include <span>

#include "sim/studies/compare/measure.h"

namespace csgsim::studies {

/// Prints what limits each machine in its own picture, the shares of the most expensive primitives, and which changes
/// help most according to the rows.
void print_comparison_summary(std::span<const ComparisonRow> rows);

}  // namespace csgsim::studies
