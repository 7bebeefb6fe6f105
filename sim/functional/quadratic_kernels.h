// Kernels of instructions with quadratic expressions, additions to F, or wide fields.
// Used by tile.
#pragma once

#include <span>

#include "sim/functional/linear_kernels.h"
#include "sim/functional/quadratic_sum.h"

namespace csgsim::functional {

/// The counterpart of LinearTask for everything beyond a linear expression on lanes: squares, numbers that are added to
/// F, and fields that are too wide for lanes.
struct QuadraticTask {
  LinearKind kind = LinearKind::not_negative;
  QuadraticSum sum;                   ///< with its origin at the tile's first pixel
  unsigned width = 0;                 ///< bits of the sum that are streamed
  unsigned shift = 0;                 ///< low bits of the sum that are not part of F
  Lanes* lanes = nullptr;             ///< lanes of z, if they store it
  std::span<TileBits* const> planes;  ///< planes of z, lowest first, if they store it: only for loads and additions
};

/// Executes the task at every enabled pixel of a tile. If z is loaded or kept and F does not fit it, E := 0.
LinearResult run_quadratic(const EnabledPixels& pixels, const QuadraticTask& task);

}  // namespace csgsim::functional
