#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host/convex/polytope.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// A product of the sum that a tree multiplies out to (thesis 6.3): what primitives that are taken away leave of a
/// convex solid.
struct SolidProduct {
  Polytope whole;                         ///< the intersection of the uncomplemented primitives; never empty
  std::vector<std::uint32_t> taken_away;  ///< the complemented primitives whose boxes meet it, ascending
  std::uint32_t primitive = 0;            ///< the first uncomplemented one in tree order
};

/// Operands of unions chosen before it is an error.
inline constexpr std::uint64_t most_operands = 1'000'000;

/// Calls `use` with every product that is not empty. A branch of the tree is left as soon as what its
/// uncomplemented primitives have in common is empty, so that products of disjoint solids are never made.
///
/// A union of complements, from A - (B * C), is worked out without overlap, A - B and A * B - C: intersections of many
/// of them then have many empty products. Other unions overlap as their operands do. Throws InputError past
/// `most` operands chosen, and WorkError past the limit on work.
void for_each_product(const facet::Geometry& geometry, const csg::PositiveTree& tree,
                      const std::function<void(SolidProduct)>& use, std::uint64_t most = most_operands,
                      const Work& work = {});

}  // namespace csgsim::convex
