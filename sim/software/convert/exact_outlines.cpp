#include "sim/software/convert/exact_outlines.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

namespace csgsim::software::convert {

void ExactOutlines::add(std::span<const Fragment> fragments) {
  for (const Fragment& fragment : fragments) add(fragment);
  points_.forget_planes();
}

void ExactOutlines::add(const Fragment& fragment) {
  round_.clear();
  for (const FragmentCorner& corner : fragment.corners) {
    const std::uint32_t point = points_.add(corner.planes);
    if (point == vertices_.size()) vertices_.push_back(nullptr);
    if (corner.vertex != no_vertex && vertices_[point] == nullptr)
      vertices_[point] = &bodies_->bodies[fragment.body].vertices[corner.vertex];
    round_.push_back(point);
  }
  const std::size_t outline = find_or_add_outline(fragment.plane, fragment.is_front ? Facing::front : Facing::back);
  ++fragments_[outline];
  std::vector<PlaneSide>& sides = plane_sides_[outline];
  for (std::size_t i = 0; i < round_.size(); ++i)
    sides.push_back({{round_[i], round_[(i + 1) % round_.size()]}, fragment.corners[i].along});
}

std::size_t ExactOutlines::find_or_add_outline(std::uint32_t plane, Facing facing) {
  std::uint32_t& number = numbers_[plane][static_cast<std::size_t>(facing)];
  if (number == 0) {
    outlines_.push_back({plane, facing, {}});
    plane_sides_.emplace_back();
    fragments_.push_back(0);
    number = static_cast<std::uint32_t>(outlines_.size());
  }
  return number - 1;
}

void ExactOutlines::close() {
  for (std::vector<PlaneSide>& sides : plane_sides_) cancel_plane_sides(sides);
  OnLines found;
  for (std::size_t i = 0; i < outlines_.size(); ++i) find_within(i, found);
  split_at_points(found);
  found.clear();
  std::vector<Side> open;
  for (const std::vector<PlaneSide>& sides : plane_sides_)
    for (const PlaneSide& one : sides) open.push_back(one.side);
  cancel_opposite_sides(open);
  find_on_open(open, found);
  split_at_points(found);
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    outlines_[i].sides.reserve(plane_sides_[i].size());
    for (const PlaneSide& one : plane_sides_[i]) outlines_[i].sides.push_back(one.side);
    std::vector<PlaneSide>().swap(plane_sides_[i]);
  }
}

void ExactOutlines::cancel_plane_sides(std::vector<PlaneSide>& sides) {
  cancel_opposite_sides(sides, [](const PlaneSide& one) -> const Side& { return one.side; });
}

/// Splits sides at those points that lie on them exactly.
void ExactOutlines::split_at_points(OnLines& found) {
  PointsOnSides ends;
  for (auto& [key, one] : found) {
    std::ranges::sort(one.points);
    one.points.erase(std::unique(one.points.begin(), one.points.end()), one.points.end());
    std::vector<std::uint32_t> points =
        points_between(bodies_->planes, points_, one.line[0], one.line[1], one.planes, one.points);
    if (!points.empty()) ends.emplace(key, std::move(points));
  }
  const auto is_ended = [&](const PlaneSide& one) { return ends.contains(key_of(one.side)); };
  for (std::vector<PlaneSide>& sides : plane_sides_) {
    if (std::ranges::none_of(sides, is_ended)) continue;
    std::vector<PlaneSide> ended;
    for (const PlaneSide& one : sides) {
      std::vector<Side> parts{one.side};
      try_split_sides(ends, parts);
      for (const Side& part : parts) ended.push_back({part, one.along});
    }
    cancel_plane_sides(ended);
    sides = std::move(ended);
  }
}

/// Finds points of an outline on its own sides. The convex polygon of a single fragment has none.
void ExactOutlines::find_within(std::size_t outline, OnLines& found) const {
  if (fragments_[outline] == 1) return;
  std::vector<Side> sides;
  sides.reserve(plane_sides_[outline].size());
  for (const PlaneSide& one : plane_sides_[outline]) sides.push_back(one.side);
  const NearPoints near(points_.positions(), end_points_of(sides));
  for (const PlaneSide& one : plane_sides_[outline]) find_beside(outline, one, near, found);
}

/// Finds the ends of unmatched sides on other unmatched sides. `open` is sorted.
void ExactOutlines::find_on_open(const std::vector<Side>& open, OnLines& found) const {
  if (open.empty()) return;
  const NearPoints near(points_.positions(), end_points_of(open));
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    for (const PlaneSide& one : plane_sides_[i]) {
      const auto first = std::ranges::lower_bound(open, key_of(one.side), {}, key_of);
      if (first != open.end() && key_of(*first) == key_of(one.side)) find_beside(i, one, near, found);
    }
  }
}

void ExactOutlines::find_beside(std::size_t outline, const PlaneSide& one, const NearPoints& near,
                                OnLines& found) const {
  const Side line = ordered(one.side);
  const glm::dvec3 farthest = glm::max(glm::abs(points_.positions()[line[0]]), glm::abs(points_.positions()[line[1]]));
  const double error = 4 * error_of_place * std::max({farthest.x, farthest.y, farthest.z});
  const std::vector<PointAlong> beside = near.beside(line[0], line[1], error);
  if (beside.empty()) return;
  OnLine& on_line = found[key_of(line)];
  on_line.line = line;
  on_line.planes = {outlines_[outline].plane, one.along};
  for (const PointAlong& point : beside) on_line.points.push_back(point.point);
}

void ExactOutlines::add_whole(const std::vector<bool>& whole) {
  std::vector<std::array<bool, 2>> has(bodies_->faces.size());
  const auto for_bodies = [&](const auto& what) {
    for (std::uint32_t i = 0; i < whole.size(); ++i)
      if (whole[i]) what(bodies_->bodies[i]);
  };
  for_bodies([&](const Body& body) {
    for (const BodyFace& face : body.faces) has[face.halfspace.plane][face.halfspace.positive ? 1 : 0] = true;
  });
  for_bodies([&](const Body& body) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const glm::dvec3& vertex : body.vertices) vertices_.push_back(&vertex);
    for (const BodyPolygon& polygon : body.polygons) {
      const facet::Halfspace halfspace = body.faces[polygon.face].halfspace;
      const std::array<bool, 2>& both = has[halfspace.plane];
      const Facing facing = both[0] && both[1] ? Facing::sum : halfspace.positive ? Facing::front : Facing::back;
      std::vector<Side>& sides = outlines_[find_or_add_outline(halfspace.plane, facing)].sides;
      const std::span<const std::uint32_t> corners = body.corners_of(polygon);
      for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back({first + corners[i], first + corners[(i + 1) % corners.size()]});
    }
  });
}

glm::dvec3 ExactOutlines::place(std::uint32_t point) const {
  if (vertices_[point] != nullptr) return *vertices_[point];
  return bodies_->reference + points_.positions()[point] * bodies_->planes.unit();
}

}  // namespace csgsim::software::convert
