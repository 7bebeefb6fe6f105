// Depths of quadrics along rays.
// Used by the ray caster and by interval arithmetic.
#pragma once

#include <cstdint>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Depth interval front <= z < back; empty unless front < back.
struct Depths {
  std::int64_t front = 0;
  std::int64_t back = 0;
};

/// Intersects a depth interval with a quadric at a pixel.
Depths intersect_quadric(Depths depths, const view::View& view, facet::QuadricSide side, std::int32_t x,
                         std::int32_t y);

/// Counts the operations of a quadric at a pixel, with values of two longs: discriminant and middle by forward
/// differences, then a 31-bit root, bit by bit, if it exists.
template <class Count>
void count_quadric(const view::ScreenQuadric& quadric, Count& count) {
  count(Operation::load_long, 8);
  count(Operation::add_long, 6);
  count(Operation::store_long, 4);
  count(Operation::compare_long, 4);
  count(Operation::branch, 3);
  if (quadric.kind == view::ScreenQuadricKind::edge) return;
  count.shift(quadric.discriminant_shift);
  if (quadric.kind == view::ScreenQuadricKind::paraboloid) {
    count.shift(quadric.factor.fraction());
    count(Operation::add_long, 6);
    return;
  }
  constexpr std::uint64_t root_bits = 31;
  count(Operation::compare_long, 2 * root_bits);
  count(Operation::branch, root_bits);
  count(Operation::add_long, 4 * root_bits);
  count(Operation::shift_long, 2 * root_bits);
  count(Operation::shifted_bit, 2 * root_bits);
  count(Operation::branch_taken, root_bits);
  count(Operation::add_long, 4);
}

}  // namespace csgsim::software
