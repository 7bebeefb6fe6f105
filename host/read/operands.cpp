#include "host/read/operands.h"

#include <utility>

#include "host/flat/combine.h"

namespace csgsim::read {

namespace {

void append(model::Tree tree, model::Tree& to) {
  const auto nodes = static_cast<std::uint32_t>(to.nodes.size());
  const auto primitives = static_cast<std::uint32_t>(to.primitives.size());
  for (model::Node& node : tree.nodes) {
    if (node.is_leaf) node.primitive += primitives;
    for (std::uint32_t& child : node.children) child += nodes;
    to.nodes.push_back(std::move(node));
  }
  for (model::Primitive& primitive : tree.primitives) to.primitives.push_back(std::move(primitive));
}

}  // namespace

flat::Area union_of_areas(const Operands& operands) { return flat::unite(operands.areas, operands.work); }

bool has_area(const Operands& operands) {
  return operands.areas.size() > 1 || (operands.areas.size() == 1 && !operands.areas.front().empty());
}

model::Tree union_of_solids(Operands operands) {
  if (operands.solids.size() == 1) return std::move(operands.solids.front());
  model::Tree all;
  model::Node root;
  for (model::Tree& solid : operands.solids) {
    append(std::move(solid), all);
    root.children.push_back(static_cast<std::uint32_t>(all.nodes.size() - 1));
  }
  if (root.children.empty()) return all;
  all.root = static_cast<std::uint32_t>(all.nodes.size());
  all.nodes.push_back(std::move(root));
  return all;
}

}  // namespace csgsim::read
