#include "sim/software/convert/side.h"

#include <utility>

namespace csgsim::software::convert {

namespace {

/// Appends the parts of a side that is split at these points.
void try_split_sides(const Side& side, std::span<const std::uint32_t> points, std::vector<Side>& sides) {
  const bool is_forward = side[0] < side[1];
  std::uint32_t at = side[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t point = points[is_forward ? i : points.size() - 1 - i];
    sides.push_back({std::exchange(at, point), point});
  }
  sides.push_back({at, side[1]});
}

}  // namespace

std::vector<std::uint32_t> end_points_of(std::span<const Side> sides) {
  std::vector<std::uint32_t> ends;
  ends.reserve(2 * sides.size());
  for (const Side& side : sides) ends.insert(ends.end(), side.begin(), side.end());
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

bool try_split_sides(const PointsOnSides& points_on_sides, std::vector<Side>& sides) {
  const auto is_ended = [&](const Side& side) { return points_on_sides.contains(key_of(side)); };
  if (std::ranges::none_of(sides, is_ended)) return false;
  std::vector<Side> ended;
  ended.reserve(sides.size());
  for (const Side& side : sides) {
    const auto found = points_on_sides.find(key_of(side));
    try_split_sides(side, found == points_on_sides.end() ? std::span<const std::uint32_t>{} : found->second, ended);
  }
  cancel_opposite_sides(ended);
  sides = std::move(ended);
  return true;
}

}  // namespace csgsim::software::convert
