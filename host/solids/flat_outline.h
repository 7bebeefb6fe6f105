// Tests and monotone division of a projected outline, with exact predicates.
// Used by seen_outline.h, tessellation.cpp and triangle_net.h.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace csgsim::solids {

/// A corner of an outline, projected to a plane.
struct ProjectedPoint {
  float s = 0;
  float t = 0;

  bool operator==(const ProjectedPoint&) const = default;
};

/// Sweep order, from left to right; reflexive.
inline bool precedes(const ProjectedPoint& first, const ProjectedPoint& second) {
  return first.s < second.s || (first.s == second.s && first.t <= second.t);
}

/// 1 if a triangle runs counter-clockwise, -1 if clockwise, 0 if it has no area; exact.
int turn(const ProjectedPoint& a, const ProjectedPoint& b, const ProjectedPoint& c);

/// A line between two points, given by their indices.
using Link = std::pair<std::uint32_t, std::uint32_t>;

/// Whether sides meet only at their ends, and each point that is used has exactly one incoming and one outgoing side.
bool is_simple(std::span<const ProjectedPoint> points, std::span<const Link> sides);

/// Diagonals that divide the region to the left of the sides into monotone parts. The sides must be simple. A reflex
/// corner that lacks a side to its left is connected to the last point before it in its part; one that lacks a side to
/// its right is connected to the first point after it.
std::vector<Link> monotone_diagonals(std::span<const ProjectedPoint> points, std::span<const Link> sides);

}  // namespace csgsim::solids
