// The facet of a solid at depth 0, where it meets the near plane.
// Used by surface.cpp, halfspaces.cpp and display_model.cpp.
#pragma once

#include <vector>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// Whether all fronts may be at or before the near plane at some pixel, so that a surface that is the farthest of them
/// may be at depth 0. True without any front. Without the pruning `near`, true unless one of them is at depth 1 or
/// farther at every corner.
bool may_reach_near(const Context& context, const std::vector<Facet>& fronts, const csg::Block& block);

/// The facet that a solid shows at depth 0: the cap of its first primitive if the near plane cuts that open, else the
/// first front of that primitive, which rounding moved there, or a curved front if it has no other.
Facet near_facet(const Context& context, std::uint32_t primitive);

/// Whether near_facet() of the quadric's primitive is this quadric's depth, clamped to 0.
bool is_near_facet(const Context& context, const QuadricBound& bound);

}  // namespace csgsim::emit
