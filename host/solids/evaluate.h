#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::solids {

/// What a tree leaves of its primitives, as convex pieces in model space: those of one product do not overlap, but
/// those of a union may (host/convex/pieces.h). A tree that is a union has its primitives as they are faceted. Throws
/// InputError if there are too many pieces.
std::vector<model::Polyhedron> pieces_of(const model::Tree& tree);

/// Points of the same solid that hold all of its corners: its hull is theirs.
std::vector<glm::dvec3> vertices_of(const model::Tree& tree);

}  // namespace csgsim::solids
