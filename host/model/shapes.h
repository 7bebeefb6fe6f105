#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "host/model/tree.h"

/// Queries about a shape's surface; shapes.cpp implements them for each shape. Places and unit normals are in the
/// shape's own axes.
namespace csgsim::model {

std::string_view name_of(const Shape& shape);

/// Whether some part of the surface is flat.
bool has_flat_faces(const Shape& shape);

/// Whether the facet with that normal is a part of the surface, and does not stand for a curved one.
bool is_flat(const Shape& shape, const glm::dvec3& normal);

/// Radians between neighbouring facets, if the curved surface is approximated by `facets` of them.
double angle_between(const Shape& shape, std::size_t facets);

/// The normal of the curved surface that a facet stands for, at one of its vertices; nothing if there is none.
std::optional<glm::dvec3> normal_at(const Shape& shape, const glm::dvec3& vertex, const glm::dvec3& of_facet);

struct SurfacePlace {
  glm::dvec3 at;
  glm::dvec3 normal;
};

/// The place of the curved surface in that direction (a unit vector) from the z axis, at the fraction `part` of the
/// height; nothing if there is no curved surface.
std::optional<SurfacePlace> place_at(const Shape& shape, const glm::dvec2& direction, double part);

}  // namespace csgsim::model
