// Triangulation of outlines.
// Used by surface.h, flat_rounds.cpp and outlines.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

using Triangle = std::array<std::uint32_t, 3>;

/// Triangulates the interior of an outline on its points; triangles run counter-clockwise as seen from outside, and
/// their unmatched sides are those of the outline. Uses a constrained Delaunay triangulation of the plane. An outline
/// with crossing sides, which only rounding of slivers can cause, is cut into a fan of triangles per closed round.
std::vector<Triangle> triangulate(const std::vector<glm::dvec3>& points, const Outline& outline);

/// Triangles enclosed by sides that run counter-clockwise around some parts of a plane, as seen from the tip of
/// `outward`, and clockwise around others; triangles have the orientation of the sides.
struct TwoSidedTriangles {
  std::vector<Triangle> front;  ///< counter-clockwise
  std::vector<Triangle> back;
};

/// Empty if sides cross.
std::optional<TwoSidedTriangles> triangulate_two_sided(const std::vector<glm::dvec3>& points, const Outline& outline);

/// Whether the corners are exactly coplanar.
bool is_flat(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& round);

/// The closed rounds formed by the sides.
std::vector<std::vector<std::uint32_t>> rounds_of(const Outline& outline);

}  // namespace csgsim::software::convert
