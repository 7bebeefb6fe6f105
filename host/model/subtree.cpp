#include "host/model/subtree.h"

#include <utility>

namespace csgsim::model {

Tree subtree(const Tree& tree, std::uint32_t root, std::uint32_t first_node, std::uint32_t first_primitive) {
  Tree part;
  part.file = tree.file;
  for (std::uint32_t i = first_node; i <= root; ++i) {
    Node copy = tree.nodes[i];
    for (std::uint32_t& child : copy.children) child -= first_node;
    if (copy.is_leaf) {
      part.primitives.push_back(tree.primitives[copy.primitive]);
      copy.primitive -= first_primitive;
    }
    part.nodes.push_back(std::move(copy));
  }
  part.root = root - first_node;
  return part;
}

}  // namespace csgsim::model
