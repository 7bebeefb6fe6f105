#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"
#include "tests/agreement/mesh_depth.h"

namespace csgsim::testing {

/// Of what a closed surface bounds, by the divergence theorem; below 0 if its faces run the other way round.
double volume(const Mesh& mesh);
double volume(const model::Polyhedron& piece);

/// How often a closed surface winds around a point: the solid angle that it is seen under (van Oosterom and Strackee).
double winding(const Mesh& mesh, const glm::dvec3& point);

/// The distance to the nearest of a piece's planes, and whether all of them hold the point.
struct Membership {
  double nearest = 0;
  bool inside = false;
};

Membership membership(const model::Polyhedron& piece, const glm::dvec3& point);

/// What makes the piece no convex polyhedron that is closed, runs counter-clockwise and has its corners on the planes
/// that it says; empty if nothing does.
std::string fault(const model::Polyhedron& piece);

}  // namespace csgsim::testing
