#pragma once

#include <cstdint>

#include "sim/functional/bit_plane.h"

namespace csgsim::sim {

/// The half-plane a*x + b*y + c >= 0 of an array's pixels; |a|*x + |b|*y + |c| < 2^62 at each.
struct HalfPlane {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
};

/// plane := plane and in the half-plane, an interval of each row. Its bounds stay conservative.
void clip(BitPlane& plane, const HalfPlane& half_plane);

}  // namespace csgsim::sim
