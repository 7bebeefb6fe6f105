// Evaluation of a CSG tree to convex pieces or to points.
// Used by host/read.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// The solid of a tree as convex pieces in model space. Pieces of one product do not overlap, but those of a union may
/// (host/convex/pieces.h). If all operators are unions, the pieces are the faceted primitives. Throws InputError if
/// there are too many pieces, and WorkError if the work limit is exceeded.
std::vector<model::Polyhedron> evaluate_pieces(const model::Tree& tree, const Work& work = {});

/// Points of the solid of a tree, including all its corners, so that points and solid have the same convex hull.
std::vector<glm::dvec3> evaluate_vertices(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
