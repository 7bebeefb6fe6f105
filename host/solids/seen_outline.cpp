#include "host/solids/seen_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>

namespace csgsim::solids {

namespace {

/// Corner indices from the second corner around to the first. In libtess2, the first of equal candidates in this order
/// is chosen.
std::vector<std::uint32_t> corner_order(std::span<const glm::vec3> outline) {
  std::vector<std::uint32_t> order(outline.size());
  std::iota(order.begin(), order.end(), 0U);
  std::rotate(order.begin(), order.begin() + 1, order.end());
  return order;
}

/// The normal of the largest triangle whose base connects the two corners that are farthest apart along an axis; its
/// length is twice the area.
glm::vec3 face_normal(std::span<const glm::vec3> outline) {
  const std::vector<std::uint32_t> order = corner_order(outline);
  glm::length_t longest = 0;
  float length = -1;
  glm::vec3 low(0);
  glm::vec3 high(0);
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const auto before = [&](std::uint32_t a, std::uint32_t b) { return outline[a][axis] < outline[b][axis]; };
    const glm::vec3& least = outline[*std::min_element(order.begin(), order.end(), before)];
    const glm::vec3& most = outline[*std::max_element(order.begin(), order.end(), before)];
    if (most[axis] - least[axis] <= length) continue;
    longest = axis;
    length = most[axis] - least[axis];
    low = least;
    high = most;
  }
  if (high[longest] <= low[longest]) return {0, 0, 1};
  glm::vec3 normal(0);
  float largest = 0;
  for (const std::uint32_t corner : order) {
    const glm::vec3 candidate = glm::cross(low - high, outline[corner] - high);
    const float size = glm::dot(candidate, candidate);
    if (size <= largest) continue;
    largest = size;
    normal = candidate;
  }
  return normal;
}

glm::length_t largest_axis(const glm::vec3& vector) {
  glm::length_t axis = 0;
  for (glm::length_t i = 1; i < 3; ++i) {
    if (std::abs(vector[i]) > std::abs(vector[axis])) axis = i;
  }
  return axis;
}

float compute_area(const std::vector<ProjectedPoint>& points) {
  float area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ProjectedPoint& next = points[(i + 1) % points.size()];
    area += (points[i].s - next.s) * (points[i].t + next.t);
  }
  return area;
}

}  // namespace

std::vector<ProjectedPoint> project_outline(std::span<const glm::vec3> outline) {
  const glm::vec3 normal = face_normal(outline);
  const glm::length_t axis = largest_axis(normal);
  const float sign = normal[axis] > 0 ? 1.0F : -1.0F;
  std::vector<ProjectedPoint> points;
  for (const glm::vec3& corner : outline) points.push_back({corner[(axis + 1) % 3], sign * corner[(axis + 2) % 3]});
  if (compute_area(points) < 0) {
    for (ProjectedPoint& point : points) point.t = -point.t;
  }
  return points;
}

}  // namespace csgsim::solids
