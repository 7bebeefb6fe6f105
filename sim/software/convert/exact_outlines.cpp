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
  std::vector<PlaneSide>& sides =
      plane_sides_[outline_of(fragment.plane, fragment.is_front ? Facing::front : Facing::back)];
  for (std::size_t i = 0; i < round_.size(); ++i)
    sides.push_back({{round_[i], round_[(i + 1) % round_.size()]}, fragment.corners[i].along});
}

std::size_t ExactOutlines::outline_of(std::uint32_t plane, Facing facing) {
  std::uint32_t& number = numbers_[plane][static_cast<std::size_t>(facing)];
  if (number == 0) {
    outlines_.push_back({plane, facing, {}});
    plane_sides_.emplace_back();
    number = static_cast<std::uint32_t>(outlines_.size());
  }
  return number - 1;
}

void ExactOutlines::close() {
  std::vector<Side> open;
  for (std::vector<PlaneSide>& sides : plane_sides_) {
    cancel(sides, [](const PlaneSide& one) -> const Side& { return one.side; });
    for (const PlaneSide& one : sides) open.push_back(one.side);
  }
  cancel(open);
  const Ends ends = ends_of(open);
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    std::vector<Side>& sides = outlines_[i].sides;
    sides.reserve(plane_sides_[i].size());
    for (const PlaneSide& one : plane_sides_[i]) sides.push_back(one.side);
    std::vector<PlaneSide>().swap(plane_sides_[i]);
    end_at(ends, sides);
  }
}

/// Where sides end. Those that run as often one way as the other cancel as they are: the `open` ones alone, sorted, have
/// to end at points, and at the ends of open ones alone.
Ends ExactOutlines::ends_of(const std::vector<Side>& open) const {
  Ends ends;
  if (open.empty()) return ends;
  std::vector<bool> is_used(points_.places().size(), false);
  for (const Side& side : open) is_used[side[0]] = is_used[side[1]] = true;
  const NearPoints near(points_.places(), is_used);
  for (std::size_t i = 0; i < outlines_.size(); ++i) {
    for (const PlaneSide& one : plane_sides_[i]) {
      const Side line = ordered(one.side);
      const auto first = std::ranges::lower_bound(open, key_of(line), {}, key_of);
      if (first == open.end() || ordered(*first) != line || ends.contains(key_of(line))) continue;
      std::vector<std::uint32_t> found = between(line, {outlines_[i].plane, one.along}, near);
      if (!found.empty()) ends.emplace(key_of(line), std::move(found));
    }
  }
  return ends;
}

std::vector<std::uint32_t> ExactOutlines::between(const Side& line, std::array<std::uint32_t, 2> planes,
                                                  const NearPoints& near) const {
  const glm::dvec3 farthest = glm::max(glm::abs(points_.places()[line[0]]), glm::abs(points_.places()[line[1]]));
  const double error = 4 * error_of_place * std::max({farthest.x, farthest.y, farthest.z});
  std::vector<std::uint32_t> candidates;
  for (const PointAlong& one : near.beside(line[0], line[1], error)) candidates.push_back(one.point);
  if (candidates.empty()) return candidates;
  return points_between(bodies_->planes, points_, line[0], line[1], planes, candidates);
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
      std::vector<Side>& sides = outlines_[outline_of(halfspace.plane, facing)].sides;
      const std::span<const std::uint32_t> corners = body.corners_of(polygon);
      for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back({first + corners[i], first + corners[(i + 1) % corners.size()]});
    }
  });
}

glm::dvec3 ExactOutlines::place(std::uint32_t point) const {
  if (vertices_[point] != nullptr) return *vertices_[point];
  return bodies_->reference + points_.places()[point] * bodies_->planes.unit();
}

}  // namespace csgsim::software::convert
