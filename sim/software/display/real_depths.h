// Depths of faces without rounding to integers.
// Used to find the causes of wrong pixels.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/facet/geometry.h"
#include "host/view/projection.h"

namespace csgsim::software {

/// Depths in steps before planes are rounded to integers, computed in doubles with an error below 10^-6 steps at 20
/// depth bits. Keeps references.
class RealDepths {
 public:
  RealDepths(const facet::Geometry& geometry, const view::View& view) : geometry_(geometry), view_(view) {}

  /// The depth at which the ray of a pixel enters or leaves a primitive (`crossing` as in Event): the maximum over the
  /// planes facing the eye, or the minimum over the others. Edge-on planes have no depth.
  [[nodiscard]] double depth_of(std::uint32_t crossing, std::uint32_t column, std::uint32_t row) const {
    const bool leaves = (crossing & 1U) != 0;
    double depth = leaves ? std::numeric_limits<double>::infinity() : 0;
    for (const facet::Halfspace halfspace : geometry_.solids[crossing / 2].halfspaces) {
      const view::ScreenPlane& plane = view_.planes[halfspace.plane];
      if (!plane.representable || view::side_of(plane, halfspace) != (leaves ? view::Side::back : view::Side::front))
        continue;
      const double here = value(plane.real, column, row);
      depth = leaves ? std::min(depth, here) : std::max(depth, here);
    }
    return depth;
  }

  /// Depths that differ by more than this number of steps have the same order as integers. The planes of the two faces
  /// and the separating plane each add a rounding error (docs/numbers.md), and floor() less than one step.
  [[nodiscard]] double rounding(std::uint32_t column, std::uint32_t row) const {
    const double places = 1 + std::abs(across(column)) + std::abs(down(row));
    return 1 + 3 * std::ldexp(places, -static_cast<int>(view_.sampling.fraction_bits) - 1);
  }

 private:
  /// Distance from the middle of the picture.
  [[nodiscard]] double across(std::uint32_t column) const { return column - (view_.sampling.width - 1) / 2.0; }
  [[nodiscard]] double down(std::uint32_t row) const { return row - (view_.sampling.height - 1) / 2.0; }
  [[nodiscard]] double value(const view::RealLinear& linear, std::uint32_t column, std::uint32_t row) const {
    return linear.at_centre + linear.a * across(column) + linear.b * down(row);
  }

  const facet::Geometry& geometry_;
  const view::View& view_;
};

}  // namespace csgsim::software
