// Traversal of directories that halve space.
// Used by excell.cpp and kd_tree.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/software/space/clip_ray.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// A part of space: its wall and halves, or its facets.
template <class Part>
struct Halved {
  bool is_cell = false;
  std::span<const std::uint32_t> facets;  ///< facets of a cell
  int axis = 0;
  double wall = 0;
  Part low{};
  Part high{};
};

/// Clips a ray to the halves of parts of space recursively, nearer half first, down to cells (thesis algorithm 5.4).
/// `look(part, count)` returns the content of a part. Pending halves are on a stack.
template <class Part, class Count, class Look>
void walk_halves(const facet::Box& box, const Part& whole, const SpaceRay& ray, const Look& look, CellVisitor& visitor,
                 Count& count) {
  struct ToCome {
    Part part;
    RayPart ray;
  };
  const glm::dvec3 inverse = inverse_direction(ray, count);
  const RayPart clipped_ray = clip_to_box(ray, inverse, box, count);
  if (clipped_ray.empty()) return;
  std::vector<ToCome> stack{{whole, clipped_ray}};
  while (!stack.empty()) {
    const ToCome now = stack.back();
    stack.pop_back();
    count(Operation::load_long, 3);
    const Halved<Part> found = look(now.part, count);
    if (found.is_cell) {
      count(Operation::call);
      count(Operation::come_back);
      if (!visitor.visit({now.ray.begin, now.ray.end, now.ray.end, found.facets})) return;
      continue;
    }
    const double origin = ray.origin[found.axis];
    const double direction = ray.direction[found.axis];
    count(Operation::load_long, 3);
    count(Operation::branch);
    if (direction == 0) {
      count_comparisons(count, 1);
      count(Operation::store_long, 3);
      stack.push_back({origin < found.wall ? found.low : found.high, now.ray});
      continue;
    }
    const double t = (found.wall - origin) * inverse[found.axis];
    const Part& first = direction > 0 ? found.low : found.high;
    const Part& second = direction > 0 ? found.high : found.low;
    count(Operation::add_long);
    count_products(count, 1);
    count_comparisons(count, 2);
    if (t < now.ray.end) stack.push_back({second, {std::max(t, now.ray.begin), now.ray.end}});
    if (t > now.ray.begin || t >= now.ray.end) stack.push_back({first, {now.ray.begin, std::min(t, now.ray.end)}});
    count(Operation::store_long, t > now.ray.begin && t < now.ray.end ? 6 : 3);
  }
}

}  // namespace csgsim::software
