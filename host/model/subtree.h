// Copies parts of CSG trees.
// Used by host/read and host/solids.
#pragma once

#include <cstdint>

#include "host/model/tree.h"

namespace csgsim::model {

/// Copies the subtree at `root` to a separate tree. `node` and `primitive` are the indices of its first node and first
/// primitive.
Tree subtree(const Tree& tree, std::uint32_t root, std::uint32_t node, std::uint32_t primitive);

}  // namespace csgsim::model
