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

/// Angle in radians between neighbouring facets, if `facet_count` facets approximate the curved surface.
double facet_angle(const Shape& shape, std::size_t facet_count);

/// The normal at `vertex` of the curved surface that a facet with the given normal approximates; empty if there is
/// none.
std::optional<glm::dvec3> normal_at(const Shape& shape, const glm::dvec3& vertex, const glm::dvec3& facet_normal);

/// A point of a surface and the unit normal there.
struct SurfacePosition {
  glm::dvec3 at;
  glm::dvec3 normal;
};

/// The point of the curved surface in a direction (a unit vector) from the z axis, at a fraction, from 0 to 1, of the
/// height or, for a sphere, of the latitudes from pole to pole; empty if the shape has no curved surface.
std::optional<SurfacePosition> surface_position_at(const Shape& shape, const glm::dvec2& direction,
                                                   double height_fraction);

}  // namespace csgsim::model
