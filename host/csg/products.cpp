#include "host/csg/products.h"

namespace csgsim::csg {

RootedTree make_rooted_tree(const ActiveTree& active) {
  RootedTree rooted{active.nodes, active.operands.front()};
  if (active.operands.size() > 1) {
    rooted.root = static_cast<std::uint32_t>(rooted.nodes.size());
    rooted.nodes.push_back({false, false, PositiveOperator::intersect, model::no_index, 0, active.operands, {}});
  }
  return rooted;
}

std::vector<std::uint64_t> count_products(const std::vector<ActiveNode>& nodes) {
  std::vector<std::uint64_t> counts(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const ActiveNode& node = nodes[i];
    if (node.is_leaf) {
      counts[i] = 1;
      continue;
    }
    const bool adds = node.op == PositiveOperator::unite;
    counts[i] = adds ? 0 : 1;
    for (const std::uint32_t child : node.children) {
      const bool overflows = adds ? __builtin_add_overflow(counts[i], counts[child], &counts[i])
                                  : __builtin_mul_overflow(counts[i], counts[child], &counts[i]);
      if (overflows || counts[child] == countless) {
        counts[i] = countless;
        break;
      }
    }
  }
  return counts;
}

ProductTraversal::ProductTraversal(const std::vector<ActiveNode>& nodes, std::uint32_t root)
    : nodes_(nodes), root_(root), chosen_(nodes.size(), 0) {
  visit();
}

void ProductTraversal::visit() {
  unions_.clear();
  leaves_.clear();
  std::vector<std::uint32_t> open{root_};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const ActiveNode& node = nodes_[at];
    if (node.is_leaf) {
      leaves_.push_back(at);
    } else if (node.op == PositiveOperator::unite) {
      unions_.push_back(at);
      open.push_back(node.children[chosen_[at]]);
    } else {
      open.insert(open.end(), node.children.rbegin(), node.children.rend());
    }
  }
}

bool ProductTraversal::next() {
  // Advances the last union that has an operand left, and restarts those visited after it.
  for (std::size_t i = unions_.size(); i-- > 0;) {
    const std::uint32_t at = unions_[i];
    if (++chosen_[at] < nodes_[at].children.size()) {
      visit();
      return true;
    }
    chosen_[at] = 0;
  }
  return false;
}

}  // namespace csgsim::csg
