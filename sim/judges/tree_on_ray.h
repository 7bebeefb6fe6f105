#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::judges {

/// A tree's value at a point that moves along a ray: primitives are switched in and out, and the operators above them
/// follow as far as anything changes. No recursion.
class TreeOnRay {
 public:
  /// The point is in no primitive.
  explicit TreeOnRay(const model::Tree& tree);

  void set(std::uint32_t primitive, bool in);

  [[nodiscard]] bool in_model() const { return root_ != model::no_index && nodes_[root_].value(); }

  /// Whether the primitive is subtracted, on the right of an odd number of differences: then it is its back that can be
  /// seen, and the point has to be out of it.
  [[nodiscard]] bool taken_away(std::uint32_t primitive) const { return nodes_[leaf_of_[primitive]].taken_away; }

  /// Whether no operator on the way to the root takes away what the primitive's surface leaves here: every operator is
  /// in there (or out, where it is subtracted itself).
  [[nodiscard]] bool shows(std::uint32_t primitive) const;

 private:
  struct Node {
    std::uint32_t parent = model::no_index;
    bool inverted = false;     ///< the parent takes it from its first child
    bool taken_away = false;   ///< on the right of an odd number of differences
    std::uint32_t right = 0;   ///< children that are as the operator would have them; leaf: 1 if in
    std::uint32_t needed = 1;  ///< how many of them make the node in

    [[nodiscard]] bool value() const { return right >= needed; }
  };

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;
  std::uint32_t root_;
};

/// The event at the first depth that is in the model just behind, of the first primitive in tree order whose surface
/// shows there; null if the ray meets nothing. Events have members `primitive` and `enters`, and are sorted by depth;
/// those of the same depth have to stand together. The tree has to be out of all primitives, and is again afterwards.
template <typename Event, typename SameDepth>
const Event* first_seen(TreeOnRay& on_ray, std::span<const Event> events, const SameDepth& same_depth) {
  const Event* seen = nullptr;
  std::size_t next = 0;
  while (next < events.size() && !on_ray.in_model()) {
    const std::size_t first = next;
    do {
      on_ray.set(events[next].primitive, events[next].enters);
      ++next;
    } while (next < events.size() && same_depth(events[next - 1], events[next]));
    if (!on_ray.in_model()) continue;
    for (const Event& event : events.subspan(first, next - first)) {
      const bool visible_side = event.enters != on_ray.taken_away(event.primitive);
      const bool before = seen == nullptr || event.primitive < seen->primitive;
      if (visible_side && before && on_ray.shows(event.primitive)) seen = &event;
    }
  }
  for (const Event& event : events.first(next)) on_ray.set(event.primitive, false);
  return seen;
}

}  // namespace csgsim::judges
