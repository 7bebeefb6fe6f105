// A CSG tree's value at a point that moves along a ray.
// Used by the truths.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::judges {

/// A tree's value at a point that moves along a ray: primitives are switched inside and outside, and only the affected
/// operators above them are updated, without recursion.
class TreeOnRay {
 public:
  /// Starts with the point outside all primitives.
  explicit TreeOnRay(const model::Tree& tree);

  /// Moves the point into a primitive or out of it.
  void set(std::uint32_t primitive, bool is_inside);

  [[nodiscard]] bool is_in_model() const { return root_ != model::no_index && nodes_[root_].value(); }

  /// Whether the primitive is subtracted, that is, on the right of an odd number of differences: then its back can be
  /// visible, and the point must be outside it.
  [[nodiscard]] bool is_subtracted(std::uint32_t primitive) const { return nodes_[leaf_of_[primitive]].is_subtracted; }

  /// Whether the primitive's surface at the point is a surface of the whole tree: the point is inside every operator on
  /// the path to the root (outside an operator that is subtracted).
  [[nodiscard]] bool is_exposed(std::uint32_t primitive) const;

 private:
  struct Node {
    std::uint32_t parent = model::no_index;
    bool is_inverted = false;    ///< the parent subtracts it from its first child
    bool is_subtracted = false;  ///< on the right of an odd number of differences
    std::uint32_t matching = 0;  ///< number of children with the value that the operator needs; leaf: 1 if inside
    std::uint32_t needed = 1;    ///< number of matching children that makes the node inside

    [[nodiscard]] bool value() const { return matching >= needed; }
  };

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;
  std::uint32_t root_;
};

/// The event at which the ray meets the visible surface: at the first depth behind which the point is in the model,
/// that of the first primitive in tree order whose surface is exposed. Null if the ray meets nothing. Events have
/// members `primitive` and `enters` and are sorted by depth. `on_ray` must be outside all primitives, and is again on
/// return.
template <typename Event, typename SameDepth>
const Event* first_seen(TreeOnRay& on_ray, std::span<const Event> events, const SameDepth& same_depth) {
  const Event* seen = nullptr;
  std::size_t next = 0;
  while (next < events.size() && !on_ray.is_in_model()) {
    const std::size_t first = next;
    do {
      on_ray.set(events[next].primitive, events[next].enters);
      ++next;
    } while (next < events.size() && same_depth(events[next - 1], events[next]));
    if (!on_ray.is_in_model()) continue;
    for (const Event& event : events.subspan(first, next - first)) {
      const bool visible_side = event.enters != on_ray.is_subtracted(event.primitive);
      const bool before = seen == nullptr || event.primitive < seen->primitive;
      if (visible_side && before && on_ray.is_exposed(event.primitive)) seen = &event;
    }
  }
  for (const Event& event : events.first(next)) on_ray.set(event.primitive, false);
  return seen;
}

}  // namespace csgsim::judges
