#pragma once

#include <vector>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// Whether all the fronts may be before the near plane, or at it, at some pixel: whether a surface that is the farthest
/// of them may be at depth 0. Without any front it is. Without pruning `near`, they may unless one of them is at depth
/// 1 or behind it at every corner.
bool may_reach_near(const Context& context, const std::vector<Facet>& fronts, const csg::Block& block);

/// What is seen at depth 0 of a solid that may reach it, whatever facets are there: its first primitive's cap if the
/// near plane cuts that open, else the first of that primitive's fronts, which rounding has taken there; a curved one
/// if it has no other.
Facet at_near(const Context& context, std::uint32_t primitive);

/// Whether that quadric's depth, where it is 0 or before it, is what at_near has of its primitive.
bool is_at_near(const Context& context, const QuadricBound& bound);

}  // namespace csgsim::emit
