// Classification of surface sequences that come from front to back.
// Used by ray tracing and by the display methods.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/coherences/first_point.h"
#include "sim/software/coherences/list_structure.h"
#include "sim/software/cost/operations.h"
#include "sim/software/methods/evaluations.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/traversals/status.h"
#include "sim/software/tree/owners.h"

namespace csgsim::software {

/// Sequences of surfaces as elements of the list structure, to which pixels have pointers (thesis 4.5.4, algorithm
/// 4.1). A new sequence is evaluated by a status tree.
template <class Count>
class Sequences {
 public:
  static constexpr std::uint32_t none = ListElements<Count>::none;

  /// Keeps a reference to the tree.
  Sequences(const Tree& tree, Count& count)
      : elements_(tree, count), evaluator_(tree), owners_(tree), held_(tree.leaf_of.size()) {}

  /// The sequence `element` continued by a surface of `primitive`; created if it is new. `element` may be none.
  std::uint32_t after(std::uint32_t element, std::uint32_t primitive, Count& count) {
    return elements_.after(element, primitive, count);
  }

  /// The last surface of a sequence.
  [[nodiscard]] std::uint32_t primitive(std::uint32_t element) const { return elements_.primitive_of(element); }
  /// The sequence without its last surface.
  [[nodiscard]] std::uint32_t before(std::uint32_t element) const { return elements_.parent_of(element); }

  /// Whether the points behind the last surface of a sequence are inside; its last `tied` surfaces have equal depths.
  bool is_in(std::uint32_t element, std::size_t tied, Count& count) {
    const bool is_first = tied == 1 && elements_.parent_of(element) == none;
    return elements_.is_in(
        element, is_first, [&] { return evaluate_sequence(element, count); }, count);
  }

  /// The owner of the visible surface if the last `tied` surfaces, in any order, are at the same depth and enter the
  /// solid.
  std::uint32_t owner(std::uint32_t element, std::size_t tied, Count& count) {
    follow_back(element);
    std::sort(events_.end() - static_cast<std::ptrdiff_t>(tied), events_.end());
    const std::span<const Event> events(events_);
    return owners_.visible_owner(events.first(events.size() - tied), events.last(tied), count);
  }

  /// The owner of the visible surface of a ray, from its events before the surface and those at the surface's depth.
  std::uint32_t owner(std::span<const Event> before, std::span<const Event> at, Count& count) {
    return owners_.visible_owner(before, at, count);
  }

  /// The primitives that contain the point after an element: those that occur an odd number of times from
  /// the element back to the first surface.
  std::vector<std::uint32_t> primitives_at(std::uint32_t element, Count& count) {
    std::vector<std::uint32_t> met;
    for (std::uint32_t at = element; at != none; at = elements_.parent_of(at))
      met.push_back(elements_.primitive_of(at));
    elements_.count_walk_back(met.size(), count);
    for (const std::uint32_t primitive : met) held_[primitive] ^= 1U;
    std::vector<std::uint32_t> held;
    for (const std::uint32_t primitive : met) {
      if (held_[primitive] != 0) held.push_back(primitive);
      held_[primitive] = 0;
    }
    return held;
  }

  /// The first visible event of a ray; `farthest` if there is none. `event_count` receives the number of events up to
  /// the last one at that depth, or of all events.
  VisibleSurface along(std::span<const Event> events, std::uint32_t farthest, Count& count,
                       std::size_t* event_count = nullptr) {
    std::uint32_t element = none;
    for (std::size_t begin = 0; begin < events.size();) {
      std::size_t end = begin;
      for (; end < events.size() && events[end].depth == events[begin].depth; ++end)
        element = after(element, events[end].primitive(), count);
      count.point();
      count(Operation::load_long, 1 + end - begin);
      count(Operation::compare_long, end - begin);
      count(Operation::branch, end - begin);
      if (is_in(element, end - begin, count)) {
        if (event_count != nullptr) *event_count = end;
        return {events[begin].depth,
                owners_.visible_owner(events.first(begin), events.subspan(begin, end - begin), count)};
      }
      begin = end;
    }
    if (event_count != nullptr) *event_count = events.size();
    return {farthest, VisibleSurface::nothing_seen};
  }

  [[nodiscard]] std::uint64_t words() const { return elements_.words() + evaluator_.words(); }

 private:
  void follow_back(std::uint32_t element) {
    primitives_.clear();
    for (; element != none; element = elements_.parent_of(element))
      primitives_.push_back(elements_.primitive_of(element));
    events_.clear();
    for (std::size_t i = primitives_.size(); i-- > 0;) {
      const auto behind = primitives_.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      const bool leaves = std::count(behind, primitives_.end(), primitives_[i]) % 2 != 0;
      events_.push_back({0, 2 * primitives_[i] + (leaves ? 1 : 0)});
    }
  }

  bool evaluate_sequence(std::uint32_t element, Count& count) {
    primitives_.clear();
    for (; element != none; element = elements_.parent_of(element))
      primitives_.push_back(elements_.primitive_of(element));
    elements_.count_walk_back(primitives_.size(), count);
    evaluator_.start(count);
    for (const std::uint32_t primitive : primitives_) evaluator_.flip(primitive, count);
    return evaluator_.evaluate(count);
  }

  ListElements<Count> elements_;
  Evaluator<StatusTree<Count>, Count> evaluator_;
  Owners<Count> owners_;
  std::vector<std::uint32_t> primitives_;
  std::vector<Event> events_;
  std::vector<std::uint8_t> held_;  ///< all 0 between calls
};

}  // namespace csgsim::software
