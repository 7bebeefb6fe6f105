#pragma once

#include <vector>

#include "host/emit/context.h"

namespace csgsim::emit {

/// The half-spaces of a primitive on one side that have to be broadcast for a block.
struct Deciding {
  std::vector<facet::Halfspace> halfspaces;  ///< in the order of the faces
  bool nothing = false;                      ///< one of them holds nothing of the block
};

/// Leaves out half-spaces that hold the whole block, and those that another one of the side stands before at every
/// corner of the block's pixels (thesis 7.3.3), if such pruning is asked for. Throws InputError, naming the primitive,
/// where the coefficients of one that decides do not fit the machine.
Deciding deciding(const Context& context, std::uint32_t primitive, view::Side side, const csg::Block& block);

/// Edge tests of a primitive that cut the block: E stays 1 inside them.
void emit_edges(const Context& context, Broadcast& out, std::uint32_t primitive, const csg::Block& block);

}  // namespace csgsim::emit
