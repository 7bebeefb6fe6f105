#include "sim/judges/tree_on_ray.h"

namespace csgsim::judges {

TreeOnRay::TreeOnRay(const model::Tree& tree)
    : nodes_(tree.nodes.size()), leaf_of_(tree.primitives.size()), root_(tree.root) {
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const model::Node& from = tree.nodes[i];
    if (from.is_leaf) {
      leaf_of_[from.primitive] = i;
      continue;
    }
    Node& node = nodes_[i];
    node.needed = from.op == model::Operator::unite ? 1 : static_cast<std::uint32_t>(from.children.size());
    for (std::size_t c = 0; c < from.children.size(); ++c) {
      Node& child = nodes_[from.children[c]];
      child.parent = i;
      child.is_inverted = from.op == model::Operator::subtract && c > 0;
      if (child.value() != child.is_inverted) ++node.matching;
    }
  }
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    const bool above = node.parent != model::no_index && nodes_[node.parent].is_subtracted;
    node.is_subtracted = above != node.is_inverted;
  }
}

void TreeOnRay::set(std::uint32_t primitive, bool is_inside) {
  Node* node = &nodes_[leaf_of_[primitive]];
  if (node->value() == is_inside) return;
  node->matching = is_inside ? 1 : 0;
  bool value = is_inside;
  while (node->parent != model::no_index) {
    Node& parent = nodes_[node->parent];
    const bool before = parent.value();
    value != node->is_inverted ? ++parent.matching : --parent.matching;
    if (parent.value() == before) return;
    value = parent.value();
    node = &parent;
  }
}

bool TreeOnRay::is_exposed(std::uint32_t primitive) const {
  for (std::uint32_t at = leaf_of_[primitive]; at != model::no_index; at = nodes_[at].parent) {
    if (nodes_[at].value() == nodes_[at].is_subtracted) return false;
  }
  return true;
}

}  // namespace csgsim::judges
