#include "host/flat/clip_steps.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace csgsim::flat {

namespace {

constexpr std::string_view combining = "combining 2-D shapes";

/// Costs of a side, of a side at one height, and of a crossing of two sides.
constexpr std::uint64_t side_steps = 500;
constexpr std::uint64_t height_steps = 20;
constexpr std::uint64_t crossing_steps = 400;

/// A side, from its lower end to its upper end. Doubles suffice: sides are only counted, so rounding has no effect.
struct Side {
  double low_x = 0;
  double low_y = 0;
  double high_x = 0;
  double high_y = 0;
};

std::vector<Side> collect_sides(const ClipperLib::Paths& paths) {
  std::vector<Side> sides;
  for (const ClipperLib::Path& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const ClipperLib::IntPoint* low = &path[i];
      const ClipperLib::IntPoint* high = &path[i + 1 < path.size() ? i + 1 : 0];
      if (high->Y < low->Y) std::swap(low, high);
      sides.push_back({static_cast<double>(low->X), static_cast<double>(low->Y), static_cast<double>(high->X),
                       static_cast<double>(high->Y)});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.low_y < b.low_y; });
  return sides;
}

/// Charges each side for the number of corner heights along it. Sides are sorted by their lower ends.
void charge_heights(const std::vector<Side>& sides, const Work& work) {
  std::vector<double> heights;
  for (const Side& side : sides) heights.insert(heights.end(), {side.low_y, side.high_y});
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  for (const Side& side : sides) {
    const auto low = std::lower_bound(heights.begin(), heights.end(), side.low_y);
    const auto high = std::lower_bound(low, heights.end(), side.high_y);
    work.charge(height_steps * static_cast<std::uint64_t>(high - low + 1), combining);
  }
}

/// Twice the signed area of the triangle of a side and a point; the sign shows on which side of the line the point is.
double turn(const Side& side, double x, double y) {
  return (side.high_x - side.low_x) * (y - side.low_y) - (side.high_y - side.low_y) * (x - side.low_x);
}

bool are_apart(double one, double other) { return (one < 0) != (other < 0) && one != 0 && other != 0; }

bool cross(const Side& one, const Side& other) {
  const auto [low, high] = std::minmax(one.low_x, one.high_x);
  if (std::max(other.low_x, other.high_x) < low || std::min(other.low_x, other.high_x) > high) return false;
  return are_apart(turn(one, other.low_x, other.low_y), turn(one, other.high_x, other.high_y)) &&
         are_apart(turn(other, one.low_x, one.low_y), turn(other, one.high_x, one.high_y));
}

/// Counts crossings in an upward sweep over the lower ends, with the sides that are active at each end.
void charge_crossings(const std::vector<Side>& sides, const Work& work) {
  std::vector<Side> active;
  for (const Side& side : sides) {
    work.charge(active.size(), combining);
    std::uint64_t crossings = 0;
    std::size_t kept = 0;
    for (const Side& other : active) {
      if (other.high_y < side.low_y) continue;
      if (cross(other, side)) ++crossings;
      active[kept++] = other;
    }
    active.resize(kept);
    active.push_back(side);
    work.charge(crossing_steps * crossings, combining);
  }
}

}  // namespace

void charge_clipping(const ClipperLib::Paths& paths, const Work& work) {
  const std::vector<Side> sides = collect_sides(paths);
  work.charge(side_steps * sides.size(), combining);
  charge_heights(sides, work);
  charge_crossings(sides, work);
}

}  // namespace csgsim::flat
