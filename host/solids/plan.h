#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// What it takes, in steps of work, to make a corner of a solid and to find the hull of its x and y with others.
inline constexpr std::uint64_t projected_corner_steps = 400;

/// The operands of the unions at the root of a tree, by their nodes in order; none of an empty tree.
std::vector<std::uint32_t> terms_of(const model::Tree& tree);

/// The corners of convex pieces whose union is the tree, along z on the x, y plane: a list a piece. Each operand of the
/// unions is evaluated without the others, and where parts of it are far apart along z for its width, these without
/// each other: the tolerances of host/convex/clip.h, which are relative to the size of what is evaluated, depend on
/// nothing that cannot change the shadow. Throws as pieces_of() does (evaluate.h).
std::vector<std::vector<glm::dvec2>> plan_of_pieces(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
