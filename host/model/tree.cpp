#include "host/model/tree.h"

namespace csgsim::model {

Counts count(const Tree& tree) {
  Counts counts;
  counts.primitives = tree.primitives.size();
  for (const Node& node : tree.nodes) {
    if (node.is_leaf) continue;
    const std::uint64_t binary = node.children.size() - 1;
    switch (node.op) {
      case Operator::unite: counts.unions += binary; break;
      case Operator::subtract: counts.differences += binary; break;
      case Operator::intersect: counts.intersections += binary; break;
    }
  }
  return counts;
}

}  // namespace csgsim::model
