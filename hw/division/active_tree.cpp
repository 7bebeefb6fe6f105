#include "hw/division/active_tree.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace csgsim::division {

namespace {

/// Result of pruning a node: decided, or a term.
struct Outcome {
  Containment known = Containment::depends;
  std::uint32_t term = 0;  ///< valid if `known` is depends
};

class Pruner {
 public:
  Pruner(Datapath& path, const Tree& tree, const Candidates& candidates, const Surface& surface)
      : path_(path), tree_(tree), candidates_(candidates), surface_(surface) {}

  ActiveTree run() {
    bool is_empty = false;
    std::uint32_t below = tree_.leaf_of[surface_.first];
    for (std::uint32_t at = tree_.nodes[below].parent; at != no_node; below = at, at = tree_.nodes[at].parent) {
      path_.visit_node();
      const TreeNode& node = tree_.nodes[at];
      if (node.op != Operator::intersect) continue;
      for (const std::uint32_t sibling : node.operands) {
        if (sibling == below) continue;
        const Outcome outcome = prune(sibling);
        is_empty = is_empty || outcome.known == Containment::out;
        if (outcome.known == Containment::depends) add_operand(active_.operands, outcome.term, Operator::intersect);
      }
    }
    if (is_empty) return {true, {}, {}};
    join(active_.operands, Operator::intersect);
    return std::move(active_);
  }

 private:
  /// Visits the node and, recursively, the operands of each node whose box meets the surface's; then evaluates them
  /// bottom-up.
  Outcome prune(std::uint32_t root) {
    visited_.clear();
    for (std::uint32_t at = root + 1; at > tree_.nodes[root].first;) {
      --at;
      path_.visit_node();
      visited_.push_back(at);
      // Skips the subtree: the loop continues before its first node.
      if (are_disjoint(tree_.nodes[at].box, surface_.box)) at = tree_.nodes[at].first;
    }
    outcomes_.resize(tree_.nodes.size());
    std::reverse(visited_.begin(), visited_.end());
    for (const std::uint32_t at : visited_) outcomes_[at] = evaluate(at);
    return outcomes_[root];
  }

  Outcome evaluate(std::uint32_t index) {
    const TreeNode& node = tree_.nodes[index];
    if (are_disjoint(node.box, surface_.box)) return {node.is_inside_elsewhere ? Containment::in : Containment::out, 0};
    if (node.is_leaf) return leaf(node);
    const Containment dominant = node.op == Operator::intersect ? Containment::out : Containment::in;
    std::vector<std::uint32_t> operands;
    for (const std::uint32_t operand : node.operands) {
      const Outcome& below = outcomes_[operand];
      if (below.known == dominant) return {dominant, 0};
      if (below.known == Containment::depends) add_operand(operands, below.term, node.op);
    }
    join(operands, node.op);
    if (operands.empty()) return {inverted(dominant), 0};
    if (operands.size() == 1) return {Containment::depends, operands.front()};
    return combine(std::move(operands), node.op);
  }

  Outcome leaf(const TreeNode& node) {
    if (surface_.holds(node.primitive)) return {Containment::in, 0};
    Comparison comparison{node.primitive, {}, {}};
    const Containment known = compare(node, comparison);
    const bool complemented = node.is_inside_elsewhere;
    if (known != Containment::depends) return {complemented ? inverted(known) : known, 0};
    Term term;
    term.is_leaf = true;
    term.complemented = complemented;
    term.comparisons.push_back(std::move(comparison));
    return {Containment::depends, add(std::move(term))};
  }

  Containment compare(const TreeNode& node, Comparison& comparison) {
    if (!candidates_.listed[comparison.primitive] || node.box.empty()) return Containment::out;
    comparison.pixels = overlap(node.box.pixels, surface_.box.pixels);
    bool inside = comparison.pixels == surface_.box.pixels;
    bool outside = false;
    comparison.tested =
        path_.test(comparison.primitive, candidates_.halfspaces[comparison.primitive], comparison.pixels);
    for (const TestedHalfspace& tested : comparison.tested) {
      const Containment known = classify_between(tested, surface_.box.z_low, surface_.box.z_high);
      inside = inside && known == Containment::in;
      outside = outside || known == Containment::out;
    }
    if (outside) return Containment::out;
    return inside ? Containment::in : Containment::depends;
  }

  /// Adds an operand to those of an operator. An operand with the same operator is replaced by its own operands: the
  /// shorter list is appended to the longer one.
  void add_operand(std::vector<std::uint32_t>& operands, std::uint32_t index, Operator op) {
    Term& term = active_.terms[index];
    if (term.is_leaf || term.op != op) {
      operands.push_back(index);
      return;
    }
    if (term.operands.size() > operands.size()) std::swap(term.operands, operands);
    operands.insert(operands.end(), term.operands.begin(), term.operands.end());
    term.operands.clear();
  }

  /// Merges the complemented leaves of a union, or the other leaves of an intersection (thesis 7.3.2).
  void join(std::vector<std::uint32_t>& operands, Operator op) {
    std::optional<std::uint32_t> first;
    std::vector<std::uint32_t> remaining;
    for (const std::uint32_t operand : operands) {
      Term& term = active_.terms[operand];
      const bool joins = term.is_leaf && term.complemented == (op == Operator::unite);
      if (joins && first) {
        std::vector<Comparison>& into = active_.terms[*first].comparisons;
        std::move(term.comparisons.begin(), term.comparisons.end(), std::back_inserter(into));
        continue;
      }
      if (joins) first = operand;
      remaining.push_back(operand);
    }
    operands = std::move(remaining);
  }

  /// Evaluates the operand that needs most bits first, which minimizes the number of intermediate results (Ershov,
  /// Sethi and Ullman).
  Outcome combine(std::vector<std::uint32_t> operands, Operator op) {
    const auto bits = [&](std::uint32_t index) { return active_.terms[index].bits; };
    std::stable_sort(operands.begin(), operands.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return bits(a) > bits(b); });
    Term term;
    term.op = op;
    term.bits = std::max<std::uint32_t>(1, bits(operands[0]));
    if (bits(operands[1]) > 0) term.bits = std::max(term.bits, bits(operands[1]) + 1);
    term.operands = std::move(operands);
    return {Containment::depends, add(std::move(term))};
  }

  std::uint32_t add(Term term) {
    active_.terms.push_back(std::move(term));
    return static_cast<std::uint32_t>(active_.terms.size() - 1);
  }

  Datapath& path_;
  const Tree& tree_;
  const Candidates& candidates_;
  const Surface& surface_;
  ActiveTree active_;
  std::vector<std::uint32_t> visited_;
  std::vector<Outcome> outcomes_;
};

}  // namespace

ActiveTree find_active_tree(Datapath& path, const Tree& tree, const Candidates& candidates, const Surface& surface) {
  return Pruner(path, tree, candidates, surface).run();
}

}  // namespace csgsim::division
