#pragma once

#include "host/csg/active_tree.h"
#include "host/effects/flat_shading.h"
#include "host/emit/broadcast.h"
#include "host/emit/layout.h"

namespace csgsim::emit {

/// What every part of the emitter reads while it works on one segment.
struct Context {
  const model::Tree& tree;
  const facet::Scene& scene;
  const view::View& view;
  const csg::PositiveTree& positive;
  const Layout& layout;
  const effects::FlatShading& shading;

  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << view.sampling.z_bits) - 1; }
  [[nodiscard]] bool complemented(std::uint32_t primitive) const {
    return positive.nodes[positive.leaf_of[primitive]].complemented;
  }
};

/// Throws InputError, naming the primitive, unless the plane's coefficients fit the machine. Only planes that decide
/// something in the segment are asked for.
void require_representable(const Context& context, std::uint32_t primitive, facet::Halfspace halfspace);

/// Edge tests of a primitive that cut the block: E stays 1 inside them.
void emit_edges(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block);

/// A primitive's visible surface into Z1: the nearest of its front if it stands for itself, of its back if it is
/// complemented. Leaves E and the mask 1 where there is one.
struct Surface {
  bool nothing = false;                  ///< no pixel can have one; then nothing was emitted
  bool near_cap = false;                 ///< the near plane may cut the solid open
  std::vector<facet::Halfspace> facets;  ///< what Z1 can come from, in order of the faces
  csg::Block block;
};
Surface emit_surface(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block);

/// Clears the mask where Z1 is out of the active tree. Returns how many primitives were compared with Z1.
std::uint64_t emit_classification(const Context& context, Broadcast& out, const csg::ActiveTree& active,
                                  const csg::Block& block);

/// Depth test of Z1 against Z2, copy of the nearer, and the colours of the facets it came from.
void emit_merge(const Context& context, Broadcast& out, std::uint32_t primitive, const Surface& surface);

}  // namespace csgsim::emit
