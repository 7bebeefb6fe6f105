// Trees of bounding boxes.
// Used by boxes.cpp and bvh.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "sim/software/space/clip_ray.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// A node of a tree of boxes.
struct BoxNode {
  facet::Box box;
  std::uint32_t low = 0;  ///< index of the first of two adjacent child nodes; 0 for a leaf
  std::uint32_t begin = 0;
  std::uint32_t end = 0;  ///< range of a leaf's facets
};

inline std::vector<SpaceBox> boxes_of(const std::vector<BoxNode>& nodes, const std::vector<std::uint32_t>& facets) {
  std::vector<SpaceBox> boxes;
  boxes.reserve(nodes.size());
  for (const BoxNode& node : nodes) {
    boxes.push_back({node.box, node.low, {}});
    if (node.low == 0) boxes.back().facets = std::span(facets).subspan(node.begin, node.end - node.begin);
  }
  return boxes;
}

/// Records the size of a tree of boxes over `facets` facets in `built`.
inline void count_boxes(const std::vector<BoxNode>& nodes, std::size_t facets, SpaceBuilt& built) {
  built.entries = nodes.size();
  built.references = built.bucket_words = facets;
  built.directory_words = 8 * nodes.size();
  for (const BoxNode& node : nodes) {
    if (node.low != 0) continue;
    ++built.cells;
    built.most_facets = std::max<std::uint64_t>(built.most_facets, node.end - node.begin);
  }
}

/// Visits the leaves of a tree of boxes in the order in which a ray enters their boxes: the node whose box is entered
/// first is processed next (Kay and Kajiya 1986). `ready(node, count)` may expand a node before it is processed.
template <class Count, class Ready>
void walk_boxes(const std::vector<BoxNode>& nodes, const std::vector<std::uint32_t>& facets, const SpaceRay& ray,
                const Ready& ready, CellVisitor& visitor, Count& count) {
  struct Met {
    RayPart ray;
    std::uint32_t node;
    bool operator>(const Met& other) const { return ray.begin > other.ray.begin; }
  };
  std::vector<Met> heap;
  const glm::dvec3 inverse = inverse_direction(ray, count);
  const auto meet = [&](std::uint32_t node) {
    const RayPart part = clip_to_box(ray, inverse, nodes[node].box, count);
    if (part.empty()) return;
    heap.push_back({part, node});
    std::ranges::push_heap(heap, std::greater{});
    for (std::size_t size = heap.size(); size > 1; size /= 2) count_comparisons(count, 1);
    count(Operation::store_long, 2);
  };
  meet(0);
  while (!heap.empty()) {
    std::ranges::pop_heap(heap, std::greater{});
    const Met met = heap.back();
    heap.pop_back();
    for (std::size_t size = heap.size(); size > 0; size /= 2) {
      count_comparisons(count, 2);
      count(Operation::store_long, 2);
    }
    ready(met.node, count);
    const BoxNode& node = nodes[met.node];
    count(Operation::load_long, 2);
    count(Operation::branch);
    if (node.low != 0) {
      const std::uint32_t low = node.low;
      meet(low);
      meet(low + 1);
      continue;
    }
    const double settled = heap.empty() ? std::numeric_limits<double>::infinity() : heap.front().ray.begin;
    const std::span<const std::uint32_t> own = std::span(facets).subspan(node.begin, node.end - node.begin);
    count(Operation::call);
    count(Operation::come_back);
    if (!visitor.visit({met.ray.begin, met.ray.end, settled, own})) return;
  }
}

}  // namespace csgsim::software
