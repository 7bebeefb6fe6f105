// Hulls and quadrics of curved primitives.
// Used by solid.cpp, host/setup and sim/studies.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "host/facet/faceting.h"
#include "host/facet/quadric_table.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// A cone whose radii differ by less than this fraction of the larger one is treated as the cylinder of its mean
/// radius. The error is at most half that fraction; double precision could not locate the apex more precisely.
inline constexpr double min_taper = 0x1p-26;

/// Maximum relative stretch or skew of a ball that is still treated as a ball: the error that OpenSCAD's six printed
/// digits cause in a rotation.
inline constexpr double ball_tolerance = 1e-5;

/// Whether a matrix consists of a rotation or reflection, a uniform scale and a translation.
bool keeps_balls(const glm::dmat4& transform);

/// Whether the primitive stays a curved surface under the options.
bool stays_curved(const model::Primitive& primitive, const Faceting& faceting);

/// A horizontal ring of vertices around the z axis. A radius of 0 makes it a single point.
struct Ring {
  double radius = 0;
  double z = 0;
};

/// Cosine and sine of `side_count` equally spaced directions around the z axis. The first is at the angle of `turn`
/// sides from the x axis.
std::vector<glm::dvec2> directions(std::uint32_t side_count, double turn);

/// Adds the vertices of a ring, one per direction. Returns their indices, one per direction.
std::vector<std::uint32_t> add_ring(Solid& solid, const Ring& ring, std::span<const glm::dvec2> around);

/// The planes of a curved solid and a hull of it, in local space. The faces are its flat ends; for a cone with an apex,
/// one more plane passes through the apex and separates the two nappes. Vertices and edges are those of a polytope
/// around the solid.
Solid curved_hull(const model::Sphere& sphere);
Solid curved_hull(const model::Cylinder& cylinder);

/// The curved surface of a primitive, in model space.
CurvedSurface curved_surface(const model::Primitive& primitive);

}  // namespace csgsim::facet
