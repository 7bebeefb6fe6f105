#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace csgsim::solids {

/// A corner of an outline as it is seen.
struct SeenPoint {
  float s = 0;
  float t = 0;

  bool operator==(const SeenPoint&) const = default;
};

/// The order in which a sweep from left to right comes by them; a point comes before itself.
inline bool comes_before(const SeenPoint& one, const SeenPoint& other) {
  return one.s < other.s || (one.s == other.s && one.t <= other.t);
}

/// 1 where a triangle runs counter-clockwise, -1 clockwise, 0 where it is flat; exact.
int turn(const SeenPoint& a, const SeenPoint& b, const SeenPoint& c);

/// Between two points, by their numbers.
using Link = std::pair<std::uint32_t, std::uint32_t>;

/// Whether sides meet at their ends alone, and at each point that is used one side ends and one begins.
bool is_simple(std::span<const SeenPoint> points, std::span<const Link> sides);

/// Diagonals that divide what is to the left of the sides, which have to be simple, into parts that a line across the
/// sweep cuts once: from each reflex corner that has no side to its left, to the last point before it of the part that
/// it is in; from one that has none to its right, to the first point after it.
std::vector<Link> monotone_diagonals(std::span<const SeenPoint> points, std::span<const Link> sides);

}  // namespace csgsim::solids
