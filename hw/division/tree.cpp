#include "hw/division/tree.h"

#include <algorithm>

namespace csgsim::division {

namespace {

void include(Box& box, const Box& more) {
  if (more.pixels.empty()) return;
  if (box.pixels.empty()) {
    box = more;
    return;
  }
  box.pixels = {std::min(box.pixels.x0, more.pixels.x0), std::min(box.pixels.y0, more.pixels.y0),
                std::max(box.pixels.x1, more.pixels.x1), std::max(box.pixels.y1, more.pixels.y1)};
  box.z_low = std::min(box.z_low, more.z_low);
  box.z_high = std::max(box.z_high, more.z_high);
}

}  // namespace

Tree make_tree(const DisplayModel& model) {
  Tree tree;
  std::vector<std::uint32_t> open;
  for (const Node& node : model.nodes) {
    const auto index = static_cast<std::uint32_t>(tree.nodes.size());
    TreeNode made{node.operands == 0, node.op, 0, no_node, index, {}, {}, false};
    if (made.is_leaf) {
      made.primitive = static_cast<std::uint32_t>(tree.leaf_of.size());
      tree.leaf_of.push_back(index);
      const Primitive& primitive = model.primitives[made.primitive];
      made.box = primitive.box;
      made.is_inside_elsewhere = primitive.complemented;
    } else {
      made.operands.assign(open.end() - static_cast<std::ptrdiff_t>(node.operands), open.end());
      open.resize(open.size() - node.operands);
      made.first = tree.nodes[made.operands.front()].first;
      const auto in = [&](std::uint32_t operand) { return tree.nodes[operand].is_inside_elsewhere; };
      made.is_inside_elsewhere = node.op == Operator::intersect
                                     ? std::all_of(made.operands.begin(), made.operands.end(), in)
                                     : std::any_of(made.operands.begin(), made.operands.end(), in);
      for (const std::uint32_t operand : made.operands) {
        tree.nodes[operand].parent = index;
        include(made.box, tree.nodes[operand].box);
      }
    }
    open.push_back(index);
    tree.nodes.push_back(std::move(made));
  }
  return tree;
}

}  // namespace csgsim::division
