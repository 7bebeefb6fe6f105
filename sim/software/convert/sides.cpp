#include "sim/software/convert/sides.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

namespace csgsim::software::convert {

namespace {

constexpr std::uint32_t none = 0xffffffffU;
constexpr std::uint32_t several = none - 1;

/// Per point, the two points that sides connect it to, if all three are collinear; otherwise `several` or `none`.
std::vector<Side> straight_neighbours(const Outlines& outlines, double tolerance) {
  std::vector<Side> neighbours(outlines.points.size(), Side{none, none});
  const auto note = [&](std::uint32_t at, std::uint32_t other) {
    Side& known = neighbours[at];
    if (known[0] == other || known[1] == other || known[0] == several) return;
    if (known[0] == none) {
      known[0] = other;
    } else if (known[1] == none) {
      known[1] = other;
    } else {
      known = {several, several};
    }
  };
  for (const Outline& outline : outlines.outlines) {
    for (const Side& side : outline.sides) {
      note(side[0], side[1]);
      note(side[1], side[0]);
    }
  }
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    Side& known = neighbours[i];
    if (known[0] == several || known[1] == none) {
      known = {none, none};
      continue;
    }
    const glm::dvec3 from = outlines.points[known[0]];
    const glm::dvec3 way = outlines.points[known[1]] - from;
    const double along = glm::dot(outlines.points[i] - from, way) / glm::dot(way, way);
    const bool is_on = along > 0 && along < 1 && glm::distance(outlines.points[i], from + along * way) <= tolerance;
    if (!is_on) known = {none, none};
  }
  return neighbours;
}

}  // namespace

std::vector<std::size_t> split_at_points(std::span<const std::size_t> outline_indices, const NearPoints& near,
                                         double tolerance, Outlines& outlines) {
  std::vector<Side> lines;
  for (const std::size_t one : outline_indices)
    for (const Side& side : outlines.outlines[one].sides) lines.push_back(ordered(side));
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  PointsOnSides ends;
  for (const Side& line : lines)
    for (const PointAlong& one : near.beside(line[0], line[1], tolerance))
      if (one.along > 0 && one.along < 1) ends[key_of(line)].push_back(one.point);
  std::vector<std::size_t> changed;
  if (ends.empty()) return changed;
  for (const std::size_t one : outline_indices)
    if (try_split_sides(ends, outlines.outlines[one].sides)) changed.push_back(one);
  return changed;
}

void join_straight(Outlines& outlines, double tolerance) {
  const std::vector<Side> neighbours = straight_neighbours(outlines, tolerance);
  const auto is_straight = [&](std::uint32_t point) { return neighbours[point][0] != none; };
  for (Outline& outline : outlines.outlines) {
    std::vector<Side> sides;
    for (const Side& side : outline.sides) {
      if (is_straight(side[0])) continue;
      Side joined = side;
      std::uint32_t from = side[0];
      while (is_straight(joined[1])) {
        const Side& next = neighbours[joined[1]];
        from = std::exchange(joined[1], next[0] == from ? next[1] : next[0]);
      }
      sides.push_back(joined);
    }
    outline.sides = std::move(sides);
  }
}

std::optional<Side> open_side(const Outlines& outlines) {
  std::vector<Side> all;
  for (const Outline& outline : outlines.outlines) all.insert(all.end(), outline.sides.begin(), outline.sides.end());
  cancel_opposite_sides(all);
  if (all.empty()) return std::nullopt;
  return all.front();
}

}  // namespace csgsim::software::convert
