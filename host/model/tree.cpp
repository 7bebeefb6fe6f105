#include "host/model/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace csgsim::model {

Counts count(const Tree& tree) {
  Counts counts;
  counts.primitives = static_cast<std::uint64_t>(std::count_if(tree.primitives.begin(), tree.primitives.end(),
                                                               [](const Primitive& one) { return !one.continues; }));
  for (const Node& node : tree.nodes) {
    if (node.is_leaf || node.of_pieces) continue;
    const std::uint64_t binary = node.children.size() - 1;
    switch (node.op) {
      case Operator::unite: counts.unions += binary; break;
      case Operator::subtract: counts.differences += binary; break;
      case Operator::intersect: counts.intersections += binary; break;
    }
  }
  return counts;
}

std::uint32_t add_leaf(Tree& tree, Primitive primitive) {
  Node leaf;
  leaf.is_leaf = true;
  leaf.primitive = static_cast<std::uint32_t>(tree.primitives.size());
  tree.primitives.push_back(std::move(primitive));
  tree.nodes.push_back(std::move(leaf));
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

std::string location_text(const Tree& tree, std::uint32_t primitive) {
  const Location& at = tree.primitives[primitive].location;
  return fmt::format("{}:{}:{}", tree.file, at.line, at.column);
}

}  // namespace csgsim::model
