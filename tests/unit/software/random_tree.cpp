#include "tests/unit/software/random_tree.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace csgsim::testing {

namespace {

std::uint32_t add(model::Tree& tree, model::Node node) {
  tree.nodes.push_back(std::move(node));
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

std::uint32_t add_leaf(model::Tree& tree) {
  const auto primitive = static_cast<std::uint32_t>(tree.primitives.size());
  tree.primitives.emplace_back();
  return add(tree, {.is_leaf = true, .primitive = primitive, .children = {}});
}

model::Operator any_operator(Random& random) {
  return random.one_of({model::Operator::unite, model::Operator::subtract, model::Operator::intersect});
}

std::uint32_t add_tree(model::Tree& tree, Random& random, unsigned primitives) {
  if (primitives == 1) return add_leaf(tree);
  model::Node node;
  node.op = any_operator(random);
  const auto operands = static_cast<unsigned>(std::min<std::uint64_t>(primitives, 2 + random.below(3)));
  unsigned left = primitives;
  for (unsigned i = operands; i > 0; --i) {
    const unsigned taken = i == 1 ? left : 1 + static_cast<unsigned>(random.below(left - i + 1));
    node.children.push_back(add_tree(tree, random, taken));
    left -= taken;
  }
  return add(tree, std::move(node));
}

}  // namespace

model::Tree random_tree(Random& random, unsigned primitives) {
  model::Tree tree;
  tree.root = add_tree(tree, random, primitives);
  return tree;
}

model::Tree chain(unsigned primitives) {
  model::Tree tree;
  tree.root = add_leaf(tree);
  for (unsigned i = 1; i < primitives; ++i) {
    const std::uint32_t leaf = add_leaf(tree);
    const model::Operator op = i % 2 == 1 ? model::Operator::unite : model::Operator::subtract;
    tree.root = add(tree, {.op = op, .children = {tree.root, leaf}});
  }
  return tree;
}

}  // namespace csgsim::testing
