#pragma once

#include <cstdint>

#include "host/model/tree.h"

namespace csgsim::model {

/// The part of a tree below a node, with it, as a tree. `node` and `primitive` are the first ones below it.
Tree subtree(const Tree& tree, std::uint32_t root, std::uint32_t node, std::uint32_t primitive);

}  // namespace csgsim::model
