// Owner of the visible surface.
// Used by all classification methods.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/traversals/status.h"
#include "sim/software/traversals/take_back.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Determines whose surface is visible where a ray enters the solid. The front of an added primitive can be visible,
/// and the back of a subtracted one. If several surfaces are at that depth, the owner is the first in tree order that
/// no operator removes.
template <class Count>
class Owners {
 public:
  /// Keeps a reference to the whole tree.
  explicit Owners(const Tree& tree) : tree_(tree), status_(tree), taken_away_(tree.nodes.size()) {
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
      const Node& node = tree.nodes[i];
      if (node.is_leaf) continue;
      taken_away_[node.left] = taken_away_[i];
      taken_away_[node.right] = taken_away_[i] != (node.op == model::Operator::subtract);
    }
  }

  /// `events_before`: the ray's nearer events; `events_at_surface`: the events at which it enters the solid.
  std::uint32_t visible_owner(std::span<const Event> events_before, std::span<const Event> events_at_surface,
                              Count& count) {
    candidates_.clear();
    for (const Event& event : events_at_surface) {
      if (event.leaves() == taken_away_[tree_.leaf_of[event.primitive()]]) candidates_.push_back(event.primitive());
    }
    count(Operation::load, 2 * events_at_surface.size());
    count(Operation::compare, events_at_surface.size());
    count(Operation::branch, events_at_surface.size());
    if (candidates_.size() == 1) return candidates_.front();
    active_.clear();
    for (const Event& event : events_before) enter_or_leave(event);
    for (const Event& event : events_at_surface) enter_or_leave(event);
    return first_visible(count);
  }

  /// The owner of the visible surface of a ray with these intervals, which enters the solid at `depth`; `active` are
  /// the primitives that contain that point.
  std::uint32_t visible_owner(std::span<const Interval> intervals, std::uint32_t depth,
                              std::span<const std::uint32_t> active, Count& count) {
    collect(intervals, depth, count);
    if (candidates_.size() == 1) return candidates_.front();
    active_.assign(active.begin(), active.end());
    return first_visible(count);
  }

  /// The only primitive whose surface can be visible at that depth; nothing_seen if there are several or none.
  std::uint32_t only_candidate(std::span<const Interval> intervals, std::uint32_t depth, Count& count) {
    collect(intervals, depth, count);
    return candidates_.size() == 1 ? candidates_.front() : VisibleSurface::nothing_seen;
  }

 private:
  void collect(std::span<const Interval> intervals, std::uint32_t depth, Count& count) {
    candidates_.clear();
    for (const Interval& interval : intervals) {
      const bool is_seen =
          taken_away_[tree_.leaf_of[interval.primitive]] ? interval.back == depth : interval.front == depth;
      if (is_seen) candidates_.push_back(interval.primitive);
    }
    count(Operation::load, intervals.size());
    count(Operation::load_long, intervals.size());
    count(Operation::compare_long, intervals.size());
    count(Operation::branch, intervals.size());
  }

  void enter_or_leave(const Event& event) {
    if (event.leaves()) {
      std::erase(active_, event.primitive());
    } else {
      active_.push_back(event.primitive());
    }
  }

  std::uint32_t first_visible(Count& count) {
    count.tie();
    flip_all(status_, active_, count);
    const auto owner =
        std::ranges::find_if(candidates_, [&](std::uint32_t candidate) { return shows(candidate, count); });
    undo_flips(status_, active_, count);
    return owner == candidates_.end() ? VisibleSurface::nothing_seen : *owner;
  }

  /// Whether the other operands of narrowing operators keep the surface, up to the root.
  bool shows(std::uint32_t primitive, Count& count) const {
    std::uint32_t below = tree_.leaf_of[primitive];
    while (below != tree_.root) {
      const std::uint32_t at = tree_.nodes[below].parent;
      const Node& node = tree_.nodes[at];
      const std::uint32_t other = node.left == below ? node.right : node.left;
      count.visit();
      count(Operation::load_long, 2);
      count(Operation::load, 3);
      count(Operation::compare, 2);
      count(Operation::branch, 2);
      const bool narrows = (node.op == model::Operator::unite) == taken_away_[at];
      if (narrows && status_.holds(other) == taken_away_[other]) return false;
      below = at;
    }
    return true;
  }

  const Tree& tree_;
  StatusTree<Count> status_;
  std::vector<bool> taken_away_;  ///< per node
  std::vector<std::uint32_t>
      candidates_;  ///< primitives with a surface that can be visible at this depth, in tree order
  std::vector<std::uint32_t> active_;
};

}  // namespace csgsim::software
