#include "hw/division/corners.h"

#include <algorithm>

namespace csgsim::division {

namespace {

using Corners = std::array<std::int64_t, 4>;

/// How far in front or behind counts: fronts by their distance, backs by its opposite.
Corners ranks(const Tested& tested) {
  Corners ranks = tested.corners;
  if (tested.side == Side::back) {
    for (std::int64_t& rank : ranks) rank = -rank;
  }
  return ranks;
}

bool is_beyond(const Corners& one, const Corners& other, std::int64_t step) {
  for (std::size_t corner = 0; corner < one.size(); ++corner) {
    if (one[corner] < other[corner] + step) return false;
  }
  return true;
}

void drop_behind(std::vector<Tested>& side, const std::vector<Corners>& judges, std::int64_t step) {
  std::erase_if(side, [&](const Tested& one) {
    const Corners mine = ranks(one);
    return std::any_of(judges.begin(), judges.end(),
                       [&](const Corners& judge) { return is_beyond(judge, mine, step); });
  });
}

}  // namespace

Tested test_corners(const DisplayModel& model, std::uint32_t primitive, const Halfspace& halfspace,
                    const Rectangle& pixels) {
  const Plane& plane = model.planes[halfspace.plane];
  const auto at = [&](std::int32_t x, std::int32_t y) { return plane.a * x + plane.b * y + plane.c; };
  Tested tested{primitive, halfspace, side_of(plane, halfspace.forward), {}, 0, 0};
  tested.corners = {at(pixels.x0, pixels.y0), at(pixels.x1, pixels.y0), at(pixels.x0, pixels.y1),
                    at(pixels.x1, pixels.y1)};
  const auto [low, high] = std::minmax_element(tested.corners.begin(), tested.corners.end());
  const unsigned fraction = plane.is_edge ? 0 : model.fraction_bits;
  tested.low = *low >> fraction;
  tested.high = *high >> fraction;
  return tested;
}

Known known_between(const Tested& tested, std::int64_t z_low, std::int64_t z_high) {
  const auto decide = [](bool in, bool out) { return in ? Known::in : out ? Known::out : Known::depends; };
  switch (tested.side) {
    case Side::front: return decide(tested.high <= z_low, tested.low > z_high);
    case Side::back: return decide(tested.low > z_high, tested.high <= z_low);
    case Side::not_negative: return decide(tested.low >= 0, tested.high < 0);
    case Side::negative: return decide(tested.high < 0, tested.low >= 0);
  }
  return Known::depends;
}

void keep_by_leaders(std::vector<Tested>& side, std::int64_t step) {
  if (side.size() < 2) return;
  std::vector<Corners> leaders(4, ranks(side.front()));
  for (const Tested& one : side) {
    const Corners mine = ranks(one);
    for (std::size_t corner = 0; corner < leaders.size(); ++corner) {
      if (mine[corner] > leaders[corner][corner]) leaders[corner] = mine;
    }
  }
  drop_behind(side, leaders, step);
}

std::uint64_t keep_extremes(std::vector<Tested>& side, std::int64_t step) {
  keep_by_leaders(side, step);
  if (side.size() < 2) return 0;
  const std::uint64_t pairs = side.size() * (side.size() - 1) / 2;
  std::vector<Corners> left;
  left.reserve(side.size());
  for (const Tested& one : side) left.push_back(ranks(one));
  drop_behind(side, left, step);
  return pairs;
}

}  // namespace csgsim::division
