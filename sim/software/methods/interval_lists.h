// Classification by merging interval lists.
// One of the rows of methods().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/method.h"
#include "sim/software/traversals/states.h"
#include "sim/software/tree/owners.h"

namespace csgsim::software {

/// Combines the whole ray with the solid: each node, in postorder, merges its operands' lists of intervals into one
/// (Roth 1982; thesis 4.1, first method). The right operand is skipped if the left one has no interval and thereby
/// decides.
template <class Count>
class IntervalLists : public Method {
 public:
  explicit IntervalLists(const Subject& subject)
      : subject_(subject), owners_(subject.tree), interval_of_(subject.tree.leaf_of.size()) {}

  void classify(const RayBand& band, std::span<VisibleSurface> seen) override {
    for (std::size_t ray = 0; ray < seen.size(); ++ray) seen[ray] = seen_along(band.intervals_of(ray));
  }

  [[nodiscard]] Counts counts() const override {
    Counts counts = count_.counts_so_far();
    counts.words = words_of(subject_.tree) + interval_of_.size() + max_ends_;
    return counts;
  }

 private:
  /// Depths at which intervals begin and end, alternating.
  using List = std::span<const std::uint32_t>;

  VisibleSurface seen_along(std::span<const Interval> intervals) {
    const VisibleSurface nothing{subject_.farthest(), VisibleSurface::nothing_seen};
    if (intervals.empty()) return nothing;
    for (const Interval& interval : intervals) interval_of_[interval.primitive] = &interval;
    count_(Operation::load, intervals.size());
    count_(Operation::store_long, 2 * intervals.size());
    ends_.clear();
    count_.evaluation();
    count_(Operation::call);
    visit(subject_.tree.root);
    for (const Interval& interval : intervals) interval_of_[interval.primitive] = nullptr;
    return ends_.empty() ? nothing : seen_at(intervals, ends_.front());
  }

  VisibleSurface seen_at(std::span<const Interval> intervals, std::uint32_t depth) {
    active_.clear();
    for (const Interval& interval : intervals) {
      if (interval.front <= depth && depth < interval.back) active_.push_back(interval.primitive);
    }
    return {depth, owners_.visible_owner(intervals, depth, active_, count_)};
  }

  /// Appends a node's list to the stack of lists.
  void visit(std::uint32_t at) {
    const Node& node = subject_.tree.nodes[at];
    count_node(node, count_);
    count_(Operation::come_back);
    if (node.is_leaf) {
      count_(Operation::load_long);
      count_(Operation::compare_long);
      count_(Operation::branch);
      if (const Interval* const interval = interval_of_[node.primitive]) {
        put(interval->front);
        put(interval->back);
      }
      return;
    }
    const std::size_t begin = ends_.size();
    count_left(count_);
    visit(node.left);
    count_(Operation::compare_long);
    count_(Operation::branch);
    if (ends_.size() == begin && node.op != model::Operator::unite) return count_.early_out();
    const std::size_t middle = ends_.size();
    count_right(count_);
    visit(node.right);
    count_(Operation::load_long);
    max_ends_ = std::max<std::uint64_t>(max_ends_, 2 * ends_.size());
    count_(Operation::compare_long);
    count_(Operation::branch);
    // An empty right operand leaves a union or difference unchanged, and makes an intersection empty.
    if (ends_.size() == middle) {
      if (node.op == model::Operator::intersect) ends_.resize(begin);
      return;
    }
    merge(node.op, begin, middle);
  }

  void put(std::uint32_t depth) {
    count_.list_element();
    count_(Operation::store_long);
    ends_.push_back(depth);
  }

  static bool holds(model::Operator op, bool left, bool right) {
    switch (op) {
      case model::Operator::unite: return left || right;
      case model::Operator::intersect: return left && right;
      case model::Operator::subtract: break;
    }
    return left && !right;
  }

  /// Merges two adjacent lists into one, in place of the left list.
  void merge(model::Operator op, std::size_t begin, std::size_t middle) {
    const List left = List(ends_).subspan(begin, middle - begin);
    const List right = List(ends_).subspan(middle);
    merged_.clear();
    std::size_t l = 0;
    std::size_t r = 0;
    bool was_in = false;
    while (l < left.size() || r < right.size()) {
      const bool takes_left = r == right.size() || (l < left.size() && left[l] <= right[r]);
      const bool takes_right = l == left.size() || (r < right.size() && right[r] <= left[l]);
      const std::uint32_t depth = takes_left ? left[l] : right[r];
      if (takes_left) ++l;
      if (takes_right) ++r;
      count_.list_step();
      count_(Operation::load_long, 2);
      count_(Operation::compare_long, 3);
      count_(Operation::branch, 2);
      count_(Operation::branch_taken, 2);
      count_(Operation::logic, 2);
      const bool is_in = holds(op, l % 2 != 0, r % 2 != 0);
      if (is_in == was_in) continue;
      was_in = is_in;
      merged_.push_back(depth);
      count_.list_element();
      count_(Operation::store_long);
    }
    ends_.resize(begin);
    ends_.insert(ends_.end(), merged_.begin(), merged_.end());
    count_(Operation::load_long, merged_.size());
    count_(Operation::store_long, merged_.size());
  }

  Subject subject_;
  Count count_;
  Owners<Count> owners_;
  std::vector<const Interval*> interval_of_;  ///< interval of each primitive along the ray
  std::vector<std::uint32_t> ends_;           ///< stack of lists to be merged
  std::vector<std::uint32_t> merged_;
  std::vector<std::uint32_t> active_;
  std::uint64_t max_ends_ = 0;  ///< maximum size in words
};

}  // namespace csgsim::software
