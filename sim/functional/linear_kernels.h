// Execution of instructions with a linear expression on the pixels of a tile.
// Used by tile.
#pragma once

#include <cstdint>

#include "hw/isa/instruction.h"
#include "sim/functional/lane_kernels.h"

namespace csgsim::functional {

/// The operation of a linear instruction on F and the number z of its field.
enum class LinearKind : std::uint8_t {
  not_negative,      ///< E := E and F >= 0
  negative,          ///< E := E and F < 0
  greater_or_equal,  ///< E := E and F >= z
  greater,           ///< E := E and F > z
  less_or_equal,     ///< E := E and F <= z
  less,              ///< E := E and F < z
  equal,             ///< E := E and F = z
  load,              ///< z := F
  keep_max,          ///< where F > z: z := F
  keep_min,          ///< where F < z: z := F
  plus,              ///< z := the low bits of F + z; only for run_quadratic
  minus,             ///< z := the low bits of F - z; only for run_quadratic
};

struct LinearTask {
  LinearKind kind = LinearKind::not_negative;
  isa::Linear linear;      ///< with c at the tile's first pixel
  Lanes* lanes = nullptr;  ///< lanes of z; width - shift of F must exceed z's width
};

struct LinearResult {
  std::uint64_t overflows = 0;  ///< enabled pixels at which a*x + b*y + c did not fit the width
  std::uint32_t enabled = 0;    ///< pixels enabled afterwards
};

/// Executes the task at every enabled pixel of a tile; `enabled_count` is their number. If z is written and F does not
/// fit it, E := 0.
LinearResult run_linear(const EnabledPixels& pixels, const LinearTask& task, std::uint32_t enabled_count);

}  // namespace csgsim::functional
