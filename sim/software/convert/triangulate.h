#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

using Triangle = std::array<std::uint32_t, 3>;

/// What an outline encloses, as triangles on its points that run counter-clockwise as seen from outside, and whose
/// sides leave those of the outline. By a constrained Delaunay triangulation of the plane; an outline whose sides cross
/// each other, which rounding can do to slivers alone, is cut into triangles from a corner of each of its rounds.
std::vector<Triangle> triangulate(const std::vector<glm::dvec3>& points, const Outline& outline);

/// What sides enclose that run counter-clockwise around some parts of a plane, as seen from where `outward` points to,
/// and clockwise around others: triangles that run as the sides do.
struct TwoSides {
  std::vector<Triangle> front;  ///< counter-clockwise
  std::vector<Triangle> back;
};

/// None if sides cross.
std::optional<TwoSides> two_sides(const std::vector<glm::dvec3>& points, const Outline& outline);

/// Whether the corners are in one plane, exactly.
bool is_flat(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& round);

/// The rounds that sides make, each once.
std::vector<std::vector<std::uint32_t>> rounds_of(const Outline& outline);

}  // namespace csgsim::software::convert
