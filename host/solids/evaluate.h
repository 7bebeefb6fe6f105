#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// What a tree leaves of its primitives, as convex pieces in model space: those of one product do not overlap, but
/// those of a union may (host/convex/pieces.h). A tree that is a union has its primitives as they are faceted. Throws
/// InputError if there are too many pieces, and WorkError past the limit on work.
std::vector<model::Polyhedron> pieces_of(const model::Tree& tree, const Work& work = {});

/// Points of the same solid that hold all of its corners: its hull is theirs.
std::vector<glm::dvec3> vertices_of(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
