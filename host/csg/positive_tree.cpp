#include "host/csg/positive_tree.h"

namespace csgsim::csg {

namespace {

PositiveOperator positive_operator(model::Operator op, bool complemented) {
  switch (op) {
    case model::Operator::unite: return complemented ? PositiveOperator::intersect : PositiveOperator::unite;
    case model::Operator::intersect:
    case model::Operator::subtract: return complemented ? PositiveOperator::unite : PositiveOperator::intersect;
  }
  return PositiveOperator::unite;
}

}  // namespace

PositiveTree make_positive_tree(const model::Tree& tree) {
  PositiveTree positive;
  positive.nodes.resize(tree.nodes.size());
  positive.root = tree.root;
  positive.leaf_of.resize(tree.primitives.size(), model::no_index);
  // Parents come after their children, so the backward pass visits a node after its `complemented` is set.
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const model::Node& node = tree.nodes[i];
    PositiveNode& made = positive.nodes[i];
    const bool complemented = made.complemented;
    made.is_leaf = node.is_leaf;
    if (node.is_leaf) {
      made.primitive = node.primitive;
      positive.leaf_of[node.primitive] = static_cast<std::uint32_t>(i);
      continue;
    }
    made.op = positive_operator(node.op, complemented);
    made.complemented = false;
    made.children = node.children;
    for (std::size_t child = 0; child < node.children.size(); ++child) {
      PositiveNode& below = positive.nodes[node.children[child]];
      below.parent = static_cast<std::uint32_t>(i);
      below.complemented = complemented != (node.op == model::Operator::subtract && child > 0);
    }
  }
  return positive;
}

}  // namespace csgsim::csg
