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
  Polytope polytope;            ///< never empty
  std::uint32_t primitive = 0;  ///< the part is of this one: the product's first uncomplemented one in tree order
  std::uint32_t product = 0;    ///< pieces of one product do not overlap; ascending from 0
};

inline constexpr std::size_t most_pieces = 100'000;

/// The model as a union of convex pieces: each of its products (for_each_product) is cut by what is taken away from it.
/// A - B is the union over B's half-spaces of A, outside of the i-th one and inside of those before it; only
/// half-spaces that the common part of A and B has a face on take part. What of a product is left in the end is merged
/// where it can be. Each cut may lose what clip() loses. Throws InputError if there are more than `most` before that,
/// and WorkError past the limit on work.
std::vector<Piece> pieces(const facet::Geometry& geometry, const csg::PositiveTree& tree,
                          std::size_t most = most_pieces, const Work& work = {});

}  // namespace csgsim::convex
