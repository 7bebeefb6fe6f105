#include "host/solids/plane_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace csgsim::solids {

namespace {

/// Number of bits of the grid: far below the 53 bits of the doubles with which Clipper intersects sides, and far above
/// the differences between corners that are meant to coincide.
constexpr int bits = 36;

using Group = std::vector<std::uint32_t>;

/// Splits a group at gaps along an axis; returns it whole if there is no gap.
std::vector<Group> split(Group group, std::span<const facet::Box> boxes, int axis) {
  std::ranges::sort(group, {}, [&](std::uint32_t i) { return boxes[i].low[axis]; });
  std::vector<Group> parts;
  double end = 0;
  for (const std::uint32_t i : group) {
    if (parts.empty() || boxes[i].low[axis] > end) {
      parts.emplace_back();
      end = boxes[i].high[axis];
    }
    end = std::max(end, boxes[i].high[axis]);
    parts.back().push_back(i);
  }
  return parts;
}

}  // namespace

std::vector<Group> group_boxes(std::span<const facet::Box> boxes) {
  struct Open {
    Group group;
    int axis = 0;        ///< axis along which to split next
    bool tried = false;  ///< whether the other axis had no gap
  };
  std::vector<Open> open(1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].empty()) open.front().group.push_back(i);
  }
  std::vector<Group> groups;
  while (!open.empty()) {
    Open one = std::move(open.back());
    open.pop_back();
    std::vector<Group> parts = split(std::move(one.group), boxes, one.axis);
    const bool is_whole = parts.size() == 1;
    for (Group& part : parts) {
      if (part.size() == 1 || (is_whole && one.tried)) {
        groups.push_back(std::move(part));
      } else {
        open.push_back({std::move(part), 1 - one.axis, is_whole});
      }
    }
  }
  return groups;
}

PlaneGrid::PlaneGrid(const facet::Box& box) : origin_(0), step_(1) {
  const glm::dvec2 low(box.low);
  const glm::dvec2 size = glm::dvec2(box.high) - low;
  const double largest = std::max(size.x, size.y);
  if (largest > 0) step_ = std::ldexp(1.0, std::ilogb(largest) - bits + 1);
  origin_ = glm::round((low + size / 2.0) / step_) * step_;
}

ClipperLib::Path PlaneGrid::to_path(const flat::Outline& outline) const {
  ClipperLib::Path path;
  path.reserve(outline.size());
  for (const glm::dvec2& corner : outline) {
    const glm::dvec2 rounded = glm::round((corner - origin_) / step_);
    path.emplace_back(static_cast<ClipperLib::cInt>(rounded.x), static_cast<ClipperLib::cInt>(rounded.y));
  }
  return path;
}

flat::Outline PlaneGrid::to_outline(const ClipperLib::Path& path) const {
  flat::Outline outline;
  outline.reserve(path.size());
  for (const ClipperLib::IntPoint& point : path)
    outline.push_back(glm::dvec2(static_cast<double>(point.X), static_cast<double>(point.Y)) * step_ + origin_);
  return outline;
}

}  // namespace csgsim::solids
