#include "tests/oracle/tree_rules.h"

namespace csgsim::testing {

namespace {

/// Evaluates for every node whether it contains the point.
std::vector<bool> evaluate(const model::Tree& tree, const std::vector<bool>& held) {
  std::vector<bool> value(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const model::Node& node = tree.nodes[i];
    if (node.is_leaf) {
      value[i] = held[node.primitive];
      continue;
    }
    bool result = value[node.children.front()];
    for (std::size_t c = 1; c < node.children.size(); ++c) {
      const bool other = value[node.children[c]];
      if (node.op == model::Operator::unite) result = result || other;
      if (node.op == model::Operator::intersect) result = result && other;
      if (node.op == model::Operator::subtract) result = result && !other;
    }
    value[i] = result;
  }
  return value;
}

}  // namespace

TreeRules::TreeRules(const model::Tree& tree)
    : tree_(tree), places_(tree.nodes.size()), leaf_of_(tree.primitives.size()) {
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const model::Node& node = tree.nodes[i];
    if (node.is_leaf) leaf_of_[node.primitive] = static_cast<std::uint32_t>(i);
    for (std::size_t c = 0; c < node.children.size(); ++c) {
      Place& child = places_[node.children[c]];
      child.parent = static_cast<std::uint32_t>(i);
      child.is_subtracted = places_[i].is_subtracted != (node.op == model::Operator::subtract && c > 0);
    }
  }
}

bool TreeRules::holds(const std::vector<bool>& held) const {
  return tree_.root != model::no_index && evaluate(tree_, held)[tree_.root];
}

bool TreeRules::shows(std::uint32_t primitive, const std::vector<bool>& held) const {
  const std::vector<bool> value = evaluate(tree_, held);
  for (std::uint32_t below = leaf_of_[primitive], at = places_[below].parent; at != model::no_index;
       below = at, at = places_[at].parent) {
    const model::Node& node = tree_.nodes[at];
    const bool narrows = (node.op == model::Operator::unite) == places_[at].is_subtracted;
    if (!narrows) continue;
    for (const std::uint32_t other : node.children) {
      if (other != below && value[other] == places_[other].is_subtracted) return false;
    }
  }
  return true;
}

}  // namespace csgsim::testing
