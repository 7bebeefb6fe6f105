// Copies parts of CSG trees.
// Used by host/read and host/solids.
#pragma once

#include <cstdint>

#include "host/model/tree.h"

namespace csgsim::model {

/// Copies the subtree at `root` to a separate tree. `first_node` and `first_primitive` are the lowest indices of its
/// nodes and primitives.
Tree subtree(const Tree& tree, std::uint32_t root, std::uint32_t first_node, std::uint32_t first_primitive);

}  // namespace csgsim::model
