#pragma once

#include <cstdint>

#include "sim/functional/bit_plane.h"

namespace csgsim::sim {

/// What a linear instruction does with F and the lanes it meets. S is A*x + B*y + C, z a lane.
enum class LinearKind : std::uint8_t {
  sign,      ///< E := E and S + bias > 0
  compare,   ///< E := E and (S + bias > z << shift)
  equal,     ///< E := E and F = z
  load,      ///< z := F
  keep_max,  ///< where S + bias > z << shift: z := F
  keep_min,  ///< where F < z: z := F
};

/// Comparisons of F = S >> shift with z become comparisons of S with z << shift, by adding a bias:
/// F >= z is S + 1 > z << shift, F > z is S - (2^shift - 1) > z << shift.
struct LinearTask {
  LinearKind kind = LinearKind::sign;
  bool wraps = false;              ///< S may not fit the width at some pixel
  bool negate = false;             ///< sign, compare: the opposite
  std::uint64_t start = 0;         ///< S at the block's first pixel, modulo 2^64
  std::uint64_t a = 0;             ///< added a column
  std::uint64_t b = 0;             ///< added a row
  std::uint64_t bias = 0;          ///< modulo 2^64
  unsigned width = 0;              ///< of S, bits
  unsigned shift = 0;              ///< fraction bits of S
  std::uint32_t* lanes = nullptr;  ///< at the block's first pixel
  unsigned field_width = 0;        ///< bits of a lane; field_width + shift < width
};

/// Does it at every enabled pixel; where a lane is written and F does not fit it, E := 0. Returns the number of enabled
/// pixels at which S did not fit the width.
std::uint64_t run_linear(const WordBlock& enable, const LinearTask& task);

}  // namespace csgsim::sim
