#include "sim/software/rays/quadric_depths.h"

#include <algorithm>

namespace csgsim::software {

namespace {

/// The interval of depths inside the quadric itself, given the non-negative value of its discriminant at the pixel.
Depths roots_of(const view::ScreenQuadric& quadric, unsigned fraction_bits, std::int64_t value, std::int32_t x,
                std::int32_t y) {
  const view::FixedLinear& m = quadric.middle;
  const std::int64_t middle = (m.a * x + m.b * y + m.c) >> fraction_bits;
  if (quadric.kind == view::ScreenQuadricKind::paraboloid) {
    const unsigned shift = quadric.discriminant_shift + quadric.factor.fraction();
    const std::int64_t half = quadric.factor.scaled() * value;
    return {middle + (-half >> shift), middle + (half >> shift) + 1};
  }
  const std::int64_t root = view::floor_root(value >> quadric.discriminant_shift);
  const std::int64_t one = std::int64_t{1} << quadric.unit;
  return {middle - root * one, middle + (root + 1) * one};
}

}  // namespace

Depths intersect_quadric(Depths depths, const view::View& view, facet::QuadricSide side, std::int32_t x,
                         std::int32_t y) {
  const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
  const view::QuadricRole role = view::role_of(quadric, side);
  const std::int64_t value = view::value_at(quadric.discriminant, x, y);
  if (role == view::QuadricRole::edge) return value >= 0 ? depths : Depths{};
  const std::int64_t shifted = value >> quadric.discriminant_shift;
  if (shifted < 0) return role == view::QuadricRole::until ? depths : Depths{};
  const Depths roots = roots_of(quadric, view.sampling.fraction_bits, value, x, y);
  switch (role) {
    case view::QuadricRole::between: return {std::max(depths.front, roots.front), std::min(depths.back, roots.back)};
    case view::QuadricRole::until: return {depths.front, std::min(depths.back, roots.front)};
    case view::QuadricRole::from: return {std::max(depths.front, roots.back), depths.back};
    case view::QuadricRole::edge: break;
  }
  return depths;
}

}  // namespace csgsim::software
