// OpenSCAD's triangulation of faces that are not flat.
// Used by bent_faces.cpp and triangle_net.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace csgsim::solids {

/// The corner indices of a triangle in an outline.
using OutlineTriangle = std::array<std::uint32_t, 3>;

/// Maximum number of corners; the running time is quadratic, since all pairs of sides are tested.
inline constexpr std::size_t max_outline_corners = 4096;

/// The triangles into which OpenSCAD 2021.01, with its libtess2, cuts a face that need not be flat; they run in the
/// direction of the outline. libtess2 projects the face in single precision along the dominant normal axis of its
/// largest triangle over its longest extent. It divides the projection into parts that are monotone along one axis,
/// cuts these into triangles from right to left, and flips diagonals until the two angles opposite to each diagonal sum
/// to less than 180.57 degrees; a square keeps the diagonal from the sweep. Holes may be joined to the outline by edges
/// that it follows in both directions. Empty if there are fewer than four or too many corners, or if the projected
/// outline touches or crosses itself; with four such corners, the first one is cut off.
std::optional<std::vector<OutlineTriangle>> tessellate(std::span<const glm::vec3> outline);

}  // namespace csgsim::solids
