// Division of a model into convex pieces.
// Used by host/effects and host/solids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/convex/polytope.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// A convex part of a model.
struct Piece {
  Polytope polytope;  ///< never empty
  /// Primitive to which the piece belongs: the product's first uncomplemented primitive in tree order.
  std::uint32_t primitive = 0;
  /// Index of the piece's product, ascending from 0; pieces of one product do not overlap.
  std::uint32_t product = 0;
};

/// Default maximum number of parts before merging.
inline constexpr std::size_t max_pieces = 100'000;

/// The model as a union of convex pieces: the subtracted primitives are cut from each of its products
/// (for_each_product). A - B is the union, over the half-spaces of B, of the part of A outside the i-th half-space and
/// inside the half-spaces before it; only half-spaces that bound the common part of A and B are used. The parts of a
/// product are then merged where possible. Each cut may lose as much as clip() loses. Throws InputError if there are
/// more than `max_count` parts before merging, and WorkError if the work limit is exceeded.
std::vector<Piece> pieces(const facet::Geometry& geometry, const csg::PositiveTree& tree,
                          std::size_t max_count = max_pieces, const Work& work = {});

}  // namespace csgsim::convex
