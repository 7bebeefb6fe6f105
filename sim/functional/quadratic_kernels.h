#pragma once

#include <span>

#include "sim/functional/linear_kernels.h"
#include "sim/functional/quadratic_sum.h"

namespace csgsim::functional {

/// What LinearTask is, for all that goes beyond a linear expression that meets lanes: squares, numbers that are added
/// to F, fields that are too wide for lanes.
struct QuadraticTask {
  LinearKind kind = LinearKind::not_negative;
  QuadraticSum sum;                   ///< from the tile's first pixel on
  unsigned width = 0;                 ///< bits of the sum that are streamed
  unsigned shift = 0;                 ///< of them, those that are no part of F
  Lanes* lanes = nullptr;             ///< of z, if lanes hold it
  std::span<TileBits* const> planes;  ///< of z, the lowest first, if they hold it: to load and to add only
};

/// Does it at every enabled pixel of a tile; where z is loaded or kept and F does not fit it, E := 0.
LinearResult run_quadratic(const Enabled& pixels, const QuadraticTask& task);

}  // namespace csgsim::functional
