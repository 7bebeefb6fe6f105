#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"
#include "tests/agreement/mesh_depth.h"

namespace csgsim::testing {

/// Volume enclosed by a closed surface, by the divergence theorem; negative if its faces are reversed.
double volume(const Mesh& mesh);
double volume(const model::Polyhedron& piece);

/// Winding number of a closed surface around a point, by the solid angle (van Oosterom and Strackee).
double winding(const Mesh& mesh, const glm::dvec3& point);

/// Distance to the nearest of a piece's planes, and whether the point is inside all of them.
struct Membership {
  double nearest = 0;
  bool inside = false;
};

Membership membership(const model::Polyhedron& piece, const glm::dvec3& point);

/// Returns why the piece is not a closed convex polyhedron with counter-clockwise faces and corners on its stated
/// planes; empty if it is.
std::string fault(const model::Polyhedron& piece);

}  // namespace csgsim::testing
