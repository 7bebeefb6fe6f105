#include "sim/judges/meant.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace csgsim::judges {

namespace {

/// A horizontal circle of corners; a single corner if the radius is 0.
struct Ring {
  long double radius = 0;
  long double z = 0;
};

/// The polyhedron between rings of `count` corners, joined by quadrangles and closed at both ends.
model::Polyhedron polyhedron_between(std::span<const Ring> rings, std::uint32_t count) {
  model::Polyhedron solid;
  std::vector<std::vector<std::uint32_t>> corners;
  for (const Ring& ring : rings) {
    std::vector<std::uint32_t>& level = corners.emplace_back();
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i == 0 || ring.radius > 0) {
        const long double angle = 2 * std::numbers::pi_v<long double> * i / count;
        solid.points.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
      }
      level.push_back(static_cast<std::uint32_t>(solid.points.size()) - 1);
    }
  }
  for (const std::size_t end : {std::size_t{0}, rings.size() - 1}) {
    if (rings[end].radius > 0) solid.faces.push_back(corners[end]);
  }
  for (std::size_t level = 0; level + 1 < corners.size(); ++level) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = (i + 1) % count;
      solid.faces.push_back({corners[level][i], corners[level][next], corners[level + 1][next], corners[level + 1][i]});
    }
  }
  return solid;
}

/// Number of corners of the primitive's circles; empty if it is intended as round.
std::optional<std::uint32_t> polygon_corners(const model::FacetControl& own, const facet::Faceting& faceting) {
  if (!std::isfinite(own.fn) || own.fn <= 0 || own.fn >= min_round_fragments(faceting)) return std::nullopt;
  return std::max(3U, static_cast<std::uint32_t>(own.fn));
}

std::optional<model::Polyhedron> polyhedron(const model::Sphere& sphere, const facet::Faceting& faceting) {
  const auto count = polygon_corners(sphere.facets, faceting);
  if (!count) return std::nullopt;
  const std::uint32_t levels = (*count + 1) / 2;
  std::vector<Ring> rings;
  for (std::uint32_t i = 0; i < levels; ++i) {
    const long double polar = std::numbers::pi_v<long double> * (i + 0.5L) / levels;
    rings.push_back({sphere.radius * std::sin(polar), sphere.radius * std::cos(polar)});
  }
  return polyhedron_between(rings, *count);
}

std::optional<model::Polyhedron> polyhedron(const model::Cylinder& cylinder, const facet::Faceting& faceting) {
  const auto count = polygon_corners(cylinder.facets, faceting);
  if (!count) return std::nullopt;
  const long double foot = cylinder.center ? -static_cast<long double>(cylinder.height) / 2 : 0;
  const Ring rings[] = {{cylinder.r1, foot}, {cylinder.r2, foot + cylinder.height}};
  return polyhedron_between(rings, *count);
}

}  // namespace

double min_round_fragments(const facet::Faceting& faceting) {
  return faceting.tolerance || faceting.fragments ? 0 : faceting.min_round_sides;
}

model::Primitive intended_solid(const model::Primitive& primitive, const facet::Faceting& faceting) {
  std::optional<model::Polyhedron> solid;
  if (const auto* sphere = std::get_if<model::Sphere>(&primitive.shape)) solid = polyhedron(*sphere, faceting);
  if (const auto* cylinder = std::get_if<model::Cylinder>(&primitive.shape)) solid = polyhedron(*cylinder, faceting);
  model::Primitive meant = primitive;
  if (solid) meant.shape = std::move(*solid);
  return meant;
}

}  // namespace csgsim::judges
