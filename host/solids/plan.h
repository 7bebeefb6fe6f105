// Projection of a solid's convex pieces to the x, y plane.
// Used by projection.cpp.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// Cost, in steps of work, of computing a corner of a solid and adding it to a hull in the x, y plane.
inline constexpr std::uint64_t projected_corner_steps = 400;

/// The operands of the unions at the root of a tree, as node indices in order; empty for an empty tree.
std::vector<std::uint32_t> union_terms(const model::Tree& tree);

/// Projects the corners of convex pieces, whose union is the tree, along z to the x, y plane: one list per piece. Each
/// operand of the unions is evaluated separately, and so are its parts if they are far apart along z relative to their
/// width. The tolerances of host/convex/clip.h are relative to the size of the evaluated geometry; evaluated in this
/// way, they depend only on solids that can change the shadow. Throws as evaluate_pieces() does (evaluate.h).
std::vector<std::vector<glm::dvec2>> project_pieces(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
