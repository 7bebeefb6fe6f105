#include "host/model/tree.h"

#include <fmt/format.h>

#include <algorithm>

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

std::string place_of(const Tree& tree, std::uint32_t primitive) {
  const Location& at = tree.primitives[primitive].location;
  return fmt::format("{}:{}:{}", tree.file, at.line, at.column);
}

}  // namespace csgsim::model
