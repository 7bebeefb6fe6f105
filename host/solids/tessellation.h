#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace csgsim::solids {

/// A triangle of corners of an outline, by their numbers.
using OutlineTriangle = std::array<std::uint32_t, 3>;

/// Every two sides of an outline are looked at, so that more would take long.
inline constexpr std::size_t most_outline_corners = 4096;

/// The triangles that OpenSCAD 2021.01, by its libtess2, cuts a face into that need not be flat, as the outline runs.
/// It looks at the face in single precision along the axis that the largest triangle at its longest extent faces most,
/// cuts what it sees into parts that are monotone along one axis and these into triangles from right to left, and turns
/// diagonals until the angles opposite to each are less than 180.57 degrees together: a square keeps the diagonal that
/// the sweep has given it. Holes may be joined to the outline by edges that it runs along both ways. Nothing for fewer
/// than four corners or too many, or where what is seen of the outline meets or crosses itself; of four corners that
/// do, the first one is cut off.
std::optional<std::vector<OutlineTriangle>> tessellate(std::span<const glm::vec3> outline);

}  // namespace csgsim::solids
