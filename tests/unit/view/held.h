#pragma once

#include <cstdint>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"

namespace csgsim::test {

/// Whether a solid contains a place, by the integers of its planes and quadrics.
inline bool is_held(const view::View& view, const facet::Convex& solid, std::int32_t x, std::int32_t y,
                    std::int64_t z) {
  for (const facet::Halfspace halfspace : solid.halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    const std::int64_t f = plane.linear.a * x + plane.linear.b * y + plane.linear.c;
    switch (view::side_of(plane, halfspace)) {
      case view::Side::front:
        if (z < f >> view.sampling.fraction_bits) return false;
        break;
      case view::Side::back:
        if (z >= f >> view.sampling.fraction_bits) return false;
        break;
      case view::Side::edge_positive:
        if (f < 0) return false;
        break;
      case view::Side::edge_negative:
        if (f >= 0) return false;
        break;
    }
  }
  for (const facet::QuadricSide side : solid.quadrics) {
    const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
    const std::int64_t d = view::value_at(quadric.discriminant, x, y) >> quadric.discriminant_shift;
    const std::int64_t q = d < 0 ? 0 : view::floor_root(d);
    const std::int64_t m =
        (quadric.middle.a * x + quadric.middle.b * y + quadric.middle.c) >> view.sampling.fraction_bits;
    const std::int64_t near = m - (q << quadric.unit);
    const std::int64_t far = m + ((q + 1) << quadric.unit);
    switch (view::role_of(quadric, side)) {
      case view::QuadricRole::between:
        if (d < 0 || z < near || z >= far) return false;
        break;
      case view::QuadricRole::until:
        if (d >= 0 && z >= near) return false;
        break;
      case view::QuadricRole::from:
        if (d < 0 || z < far) return false;
        break;
      case view::QuadricRole::edge:
        if (d < 0) return false;
        break;
    }
  }
  return true;
}

}  // namespace csgsim::test
