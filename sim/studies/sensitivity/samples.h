// Latin-hypercube samples of figures.
// Used by sim/studies/sensitivity.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/studies/sensitivity/figures.h"

namespace csgsim::studies {

/// Positions from 0 to below 1 of `samples` samples of one figure, in random order: one in each of `samples` strata of
/// equal width (McKay, Beckman and Conover 1979). They depend on the key, the number of samples and the seed only.
std::vector<double> strata(std::string_view key, std::uint32_t samples, std::uint32_t seed);

/// Whether samples are uniform in the logarithm: the low value is positive and the high one more than 4 times as high.
bool is_logarithmic(const RangedFigure& figure);

/// The value at a position of the range, which is 0 at its low and almost 1 at its high value.
std::int64_t value_at(const RangedFigure& figure, double position);

}  // namespace csgsim::studies
