#include "host/csg/convex_sets.h"

namespace csgsim::csg {

std::vector<ConvexSet> convex_sets(const PositiveTree& tree, bool joined) {
  // The topmost intersection above each node, through intersections only; parents come after their children.
  std::vector<std::uint32_t> top(tree.nodes.size());
  for (std::uint32_t i = static_cast<std::uint32_t>(tree.nodes.size()); i-- > 0;) {
    const std::uint32_t parent = tree.nodes[i].parent;
    const bool continues = parent != model::no_index && tree.nodes[parent].op == PositiveOperator::intersect;
    top[i] = continues ? top[parent] : i;
  }
  std::vector<ConvexSet> sets;
  const auto follows = [&](std::uint32_t primitive) {
    const std::uint32_t leaf = tree.leaf_of[primitive];
    const std::uint32_t before = tree.leaf_of[primitive - 1];
    return !tree.nodes[leaf].complemented && !tree.nodes[before].complemented && top[leaf] == top[before];
  };
  for (std::uint32_t primitive = 0; primitive < tree.leaf_of.size(); ++primitive) {
    if (!joined || primitive == 0 || !follows(primitive)) sets.emplace_back();
    sets.back().push_back(primitive);
  }
  return sets;
}

}  // namespace csgsim::csg
