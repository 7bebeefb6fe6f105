// Directed sides between points.
// Used by mesh conversion.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace csgsim::software::convert {

/// A directed line between two points.
using Side = std::array<std::uint32_t, 2>;

/// The side's line, from the lower to the higher point index.
inline Side ordered(const Side& side) { return {std::min(side[0], side[1]), std::max(side[0], side[1])}; }

/// Key that is equal for a side and its opposite.
inline std::uint64_t key_of(const Side& side) {
  return static_cast<std::uint64_t>(std::min(side[0], side[1])) << 32U | std::max(side[0], side[1]);
}

/// Removes elements whose sides are degenerate, and pairs of elements whose sides are opposite. Sorts the rest.
/// `side_of(element)` returns the side of an element.
template <class One, class SideOf>
void cancel_opposite_sides(std::vector<One>& all, const SideOf& side_of) {
  std::erase_if(all, [&](const One& one) { return side_of(one)[0] == side_of(one)[1]; });
  std::sort(all.begin(), all.end(), [&](const One& one, const One& other) {
    const std::uint64_t key = key_of(side_of(one));
    const std::uint64_t other_key = key_of(side_of(other));
    return key != other_key ? key < other_key : side_of(one) < side_of(other);
  });
  auto kept = all.begin();
  for (auto begin = all.begin(); begin != all.end();) {
    const Side line = ordered(side_of(*begin));
    const auto is_back = [&](const One& one) { return side_of(one) != line; };
    const auto end = std::find_if(begin, all.end(), [&](const One& one) { return ordered(side_of(one)) != line; });
    const auto back = std::find_if(begin, end, is_back);
    const std::ptrdiff_t pairs = std::min(back - begin, end - back);
    kept = std::move(begin, back - pairs, kept);
    kept = std::move(back + pairs, end, kept);
    begin = end;
  }
  all.erase(kept, all.end());
}

inline void cancel_opposite_sides(std::vector<Side>& sides) {
  cancel_opposite_sides(sides, [](const Side& side) -> const Side& { return side; });
}

/// The end points of the sides, ascending and without duplicates.
std::vector<std::uint32_t> end_points_of(std::span<const Side> sides);

/// Points on sides, by the sides' keys, sorted from the lower to the higher end point.
using PointsOnSides = std::unordered_map<std::uint64_t, std::vector<std::uint32_t>>;

/// Splits each side at its points in `points_on_sides`. Returns whether any was split.
bool try_split_sides(const PointsOnSides& points_on_sides, std::vector<Side>& sides);

}  // namespace csgsim::software::convert
