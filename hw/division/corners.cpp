#include "hw/division/corners.h"

#include <algorithm>

namespace csgsim::division {

TestedHalfspace test_corners(const ModelHeader& header, const PlacedHalfspace& placed, const Rectangle& pixels) {
  const Plane& plane = placed.plane;
  const auto at = [&](std::int32_t x, std::int32_t y) { return plane.a * x + plane.b * y + plane.c; };
  TestedHalfspace tested{placed, side_of(plane, placed.halfspace.forward), {}, 0, 0};
  tested.corners = {at(pixels.x0, pixels.y0), at(pixels.x1, pixels.y0), at(pixels.x0, pixels.y1),
                    at(pixels.x1, pixels.y1)};
  const auto [low, high] = std::minmax_element(tested.corners.begin(), tested.corners.end());
  const unsigned fraction = plane.is_edge ? 0 : header.fraction_bits;
  tested.low = *low >> fraction;
  tested.high = *high >> fraction;
  return tested;
}

Containment classify_between(const TestedHalfspace& tested, std::int64_t z_low, std::int64_t z_high) {
  const auto decide = [](bool in, bool out) {
    return in ? Containment::in : out ? Containment::out : Containment::depends;
  };
  switch (tested.side) {
    case Side::front: return decide(tested.high <= z_low, tested.low > z_high);
    case Side::back: return decide(tested.low > z_high, tested.high <= z_low);
    case Side::not_negative: return decide(tested.low >= 0, tested.high < 0);
    case Side::negative: return decide(tested.high < 0, tested.low >= 0);
  }
  return Containment::depends;
}

}  // namespace csgsim::division
