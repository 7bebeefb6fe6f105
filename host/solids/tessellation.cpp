#include "host/solids/tessellation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "host/solids/flat_outline.h"
#include "host/solids/neighbours.h"
#include "host/solids/seen_outline.h"
#include "host/solids/triangle_net.h"

namespace csgsim::solids {

namespace {

/// Maps each corner to the first corner at the same position.
std::vector<std::uint32_t> first_at_place(std::span<const glm::vec3> outline) {
  const auto order = [](const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<glm::vec3, std::uint32_t, decltype(order)> places(order);
  std::vector<std::uint32_t> first;
  for (const glm::vec3& corner : outline) {
    first.push_back(places.try_emplace(corner, static_cast<std::uint32_t>(first.size())).first->second);
  }
  return first;
}

/// The sides of an outline, except those that it follows in both directions.
std::vector<Link> collect_sides(const std::vector<std::uint32_t>& corners) {
  std::vector<Link> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Link side{corners[i], corners[(i + 1) % corners.size()]};
    const auto back = std::ranges::find(sides, Link{side.second, side.first});
    if (back != sides.end()) {
      sides.erase(back);
    } else if (side.first != side.second) {
      sides.push_back(side);
    }
  }
  return sides;
}

/// The triangles of an outline that crosses itself; empty unless it has four sides.
std::optional<std::vector<OutlineTriangle>> crossed(const std::vector<Link>& sides) {
  if (sides.size() != 4) return std::nullopt;
  return std::vector<OutlineTriangle>{{3, 0, 1}, {1, 2, 3}};
}

}  // namespace

std::optional<std::vector<OutlineTriangle>> tessellate(std::span<const glm::vec3> outline) {
  if (outline.size() < 4 || outline.size() > max_outline_corners) return std::nullopt;
  const std::vector<ProjectedPoint> points = project_outline(outline);
  const std::vector<Link> sides = collect_sides(first_at_place(outline));
  if (sides.size() < 3 || !is_simple(points, sides)) return crossed(sides);
  TriangleNet net(points, sides, monotone_diagonals(points, sides));
  net.cut_parts();
  net.flip_diagonals();
  return net.triangles();
}

}  // namespace csgsim::solids
