#include "sim/software/convert/sides.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "sim/software/convert/near_points.h"

namespace csgsim::software::convert {

namespace {

constexpr std::uint32_t none = 0xffffffffU;
constexpr std::uint32_t several = none - 1;

Side ordered(const Side& side) { return {std::min(side[0], side[1]), std::max(side[0], side[1])}; }

/// Of each point the two others that sides join it to, if they are on one line; else `several` or `none`.
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

void cancel(std::vector<Side>& sides) {
  std::erase_if(sides, [](const Side& side) { return side[0] == side[1]; });
  std::ranges::sort(sides, [](const Side& one, const Side& other) {
    const Side a = ordered(one);
    const Side b = ordered(other);
    return a != b ? a < b : one < other;
  });
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    const Side line = ordered(sides[begin]);
    std::ptrdiff_t surplus = 0;  // that run from the lower number to the higher
    for (; end < sides.size() && ordered(sides[end]) == line; ++end) surplus += sides[end] == line ? 1 : -1;
    const Side left = surplus > 0 ? line : Side{line[1], line[0]};
    for (std::ptrdiff_t i = 0; i < std::abs(surplus); ++i) sides[kept++] = left;
    begin = end;
  }
  sides.resize(kept);
}

void end_at(const Side& side, std::span<const std::uint32_t> points, std::vector<Side>& sides) {
  const bool is_forward = side[0] < side[1];
  std::uint32_t at = side[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t point = points[is_forward ? i : points.size() - 1 - i];
    sides.push_back({std::exchange(at, point), point});
  }
  sides.push_back({at, side[1]});
}

bool end_at_points(Outlines& outlines, double tolerance) {
  std::vector<bool> is_used(outlines.points.size(), false);
  for (const Outline& outline : outlines.outlines)
    for (const Side& side : outline.sides) is_used[side[0]] = is_used[side[1]] = true;
  const NearPoints near(outlines.points, is_used);
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> known;
  bool any = false;
  for (Outline& outline : outlines.outlines) {
    std::vector<Side> sides;
    for (const Side& side : outline.sides) {
      const Side line = ordered(side);
      const auto [entry, is_new] = known.try_emplace(key_of(line));
      if (is_new) {
        for (const PointAlong& one : near.beside(line[0], line[1], tolerance))
          if (one.along > 0 && one.along < 1) entry->second.push_back(one.point);
      }
      end_at(side, entry->second, sides);
    }
    if (sides.size() == outline.sides.size()) continue;
    any = true;
    cancel(sides);
    outline.sides = std::move(sides);
  }
  return any;
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
  cancel(all);
  if (all.empty()) return std::nullopt;
  return all.front();
}

}  // namespace csgsim::software::convert
