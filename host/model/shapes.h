// Queries about the surface of a shape; positions and unit normals are in the shape's local space.
// Used by host/effects and host/emit.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "host/model/tree.h"

namespace csgsim::model {

std::string_view name_of(const Shape& shape);

/// Whether some part of the surface is flat.
bool has_flat_faces(const Shape& shape);

/// Whether a facet with the given normal is part of the surface itself and does not approximate a curved surface.
bool is_flat(const Shape& shape, const glm::dvec3& normal);

/// Angle in radians between neighbouring facets, if `facets` facets approximate the curved surface.
double angle_between(const Shape& shape, std::size_t facets);

/// The normal at `vertex` of the curved surface that a facet with the normal `of_facet` approximates; empty if there is
/// none.
std::optional<glm::dvec3> normal_at(const Shape& shape, const glm::dvec3& vertex, const glm::dvec3& of_facet);

/// A point of a surface and the unit normal there.
struct SurfacePlace {
  glm::dvec3 at;
  glm::dvec3 normal;
};

/// The point of the curved surface in the direction `direction` (a unit vector) from the z axis, at the fraction `part`
/// of the height; empty if the shape has no curved surface.
std::optional<SurfacePlace> place_at(const Shape& shape, const glm::dvec2& direction, double part);

}  // namespace csgsim::model
