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

/// A cone whose radius changes by less than this part of the greater one is the cylinder of its mean radius, half that
/// part of it away at most: its apex, as a place in double precision, would be known no better.
inline constexpr double least_taper = 0x1p-26;

/// How much longer or more askew a ball may become, as a part of its size, and still count as one: what the six digits
/// that OpenSCAD writes leave of a rotation.
inline constexpr double ball_tolerance = 1e-5;

/// Whether a matrix is a rotation or reflection, a uniform scale and a shift.
bool keeps_balls(const glm::dmat4& transform);

/// Whether the shape stays a curved surface.
bool stays_curved(const model::Primitive& primitive, const Faceting& faceting);

/// A horizontal ring of vertices about the z axis. A radius of 0 makes it a single point.
struct Ring {
  double radius = 0;
  double z = 0;
};

/// Cosine and sine of as many directions around the z axis, the first of them `turn` parts of a side on from the x
/// axis.
std::vector<glm::dvec2> directions(std::uint32_t sides, double turn);

/// Adds its vertices, one a direction. Returns their numbers, one a direction.
std::vector<std::uint32_t> add_ring(Solid& solid, const Ring& ring, std::span<const glm::dvec2> around);

/// The planes and a hull of a curved solid in its own space. The faces are its flat ends; a cone that ends in its tip
/// has a plane through that, which parts it from the other nappe. Vertices and edges are those of a polytope around it.
Solid curved_hull(const model::Sphere& sphere);
Solid curved_hull(const model::Cylinder& cylinder);

/// Its curved surface in model space.
CurvedSurface curved_surface(const model::Primitive& primitive);

}  // namespace csgsim::facet
