// Enumeration of the nonempty products of a CSG tree.
// Used by extent.cpp and pieces.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host/convex/polytope.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// A product in the sum of products of a tree (thesis 6.3): a convex solid minus the subtracted primitives.
struct SolidProduct {
  Polytope whole;  ///< the intersection of the uncomplemented primitives; never empty
  /// Complemented primitives whose boxes intersect that of `whole`, in ascending order.
  std::vector<std::uint32_t> subtracted;
  std::uint32_t primitive = 0;  ///< first uncomplemented primitive in tree order
};

/// Maximum number of operands chosen from unions.
inline constexpr std::uint64_t max_operands = 1'000'000;

/// Calls `visit` with every nonempty product. A branch of the tree is abandoned as soon as the intersection of its
/// uncomplemented primitives is empty, so products of disjoint solids are never built.
///
/// A union of complements, as in A - (B * C), is expanded without overlap into A - B and A * B - C, because
/// intersections of many such unions then have many empty products. The terms of other unions overlap as their operands
/// do. Throws InputError for more than `max_choices` chosen operands, and WorkError if the work limit is exceeded.
void for_each_product(const facet::Geometry& geometry, const csg::PositiveTree& tree,
                      const std::function<void(SolidProduct)>& visit, std::uint64_t max_choices = max_operands,
                      const Work& work = {});

}  // namespace csgsim::convex
