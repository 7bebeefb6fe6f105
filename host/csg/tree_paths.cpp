#include "host/csg/tree_paths.h"

#include <algorithm>
#include <stdexcept>

namespace csgsim::csg {

TreePaths::TreePaths(const PositiveTree& tree) : tree_(tree), notes_(tree.nodes.size()) {
  const auto count = static_cast<std::uint32_t>(tree.nodes.size());
  // Children precede their parents.
  for (std::uint32_t i = 0; i < count; ++i) note_below(i);
  for (std::uint32_t i = count; i-- > 0;) {
    if (tree.nodes[i].parent == model::no_index) notes_[i].path = i;
    const std::vector<std::uint32_t>& children = tree.nodes[i].children;
    const auto primitives = [&](std::uint32_t child) { return notes_[child].last - notes_[child].first; };
    const auto heavy = std::max_element(children.begin(), children.end(), [&](std::uint32_t a, std::uint32_t b) {
      return primitives(a) < primitives(b);
    });
    for (auto child = children.begin(); child != children.end(); ++child) note_above(*child, child == heavy);
  }
}

void TreePaths::note_below(std::uint32_t index) {
  const PositiveNode& node = tree_.nodes[index];
  Note& note = notes_[index];
  if (node.is_leaf) {
    note.is_inside_elsewhere = node.complemented;
    note.first = note.last = node.primitive;
    return;
  }
  const bool dominant = node.op == PositiveOperator::unite;
  for (const std::uint32_t child : node.children) {
    Note& below = notes_[child];
    if (note.first != model::no_index && below.first <= note.last)
      throw std::logic_error("primitives are not in tree order");
    below.decides = below.is_inside_elsewhere == dominant;
    note.deciding_children += below.decides ? 1U : 0U;
    note.first = std::min(note.first, below.first);
    note.last = std::max(note.last, below.last);
  }
  note.is_inside_elsewhere = (note.deciding_children > 0) == dominant;
}

void TreePaths::note_above(std::uint32_t index, bool is_heavy) {
  const std::uint32_t parent = tree_.nodes[index].parent;
  const Note& above = notes_[parent];
  Note& note = notes_[index];
  const bool is_operand = tree_.nodes[parent].op == PositiveOperator::intersect;
  const std::uint32_t others = above.deciding_children - (note.decides ? 1U : 0U);
  note.path = is_heavy ? above.path : index;
  note.decided_above = above.decided_above + (others > 0 ? 1U : 0U);
  note.out_above = above.out_above + (is_operand && others > 0 ? 1U : 0U);
  note.operand = is_operand ? index : above.operand;
  note.top = above.top != model::no_index || !is_operand ? above.top : parent;
}

std::uint32_t TreePaths::common_ancestor(std::uint32_t first_node, std::uint32_t second_node) const {
  // Children precede parents, so the path whose top has the lower index has no node above the other path.
  while (notes_[first_node].path != notes_[second_node].path) {
    std::uint32_t& lower = notes_[first_node].path < notes_[second_node].path ? first_node : second_node;
    lower = tree_.nodes[notes_[lower].path].parent;
  }
  return std::max(first_node, second_node);
}

std::uint32_t TreePaths::child_towards(std::uint32_t node, std::uint32_t primitive) const {
  const std::vector<std::uint32_t>& children = tree_.nodes[node].children;
  return *std::lower_bound(children.begin(), children.end(), primitive,
                           [&](std::uint32_t child, std::uint32_t sought) { return notes_[child].last < sought; });
}

}  // namespace csgsim::csg
