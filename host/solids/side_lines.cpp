#include "host/solids/side_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace csgsim::solids {

namespace {

double max_magnitude(const flat::Area& area) {
  double size = 0;
  for (const flat::Outline& outline : area.outlines) {
    for (const glm::dvec2& corner : outline) size = std::max({size, std::abs(corner.x), std::abs(corner.y)});
  }
  return size;
}

}  // namespace

double signed_area(const flat::Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& a = outline[i];
    const glm::dvec2& b = outline[(i + 1) % outline.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2.0;
}

SideLines::SideLines(const flat::Area& area) : planes_(glm::dvec3(0), max_magnitude(area)) {}

glm::dvec3 SideLines::operator()(const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 normal = glm::normalize(glm::dvec2(b.y - a.y, a.x - b.x));
  const facet::Halfspace found = planes_.add({glm::dvec3(normal, 0), -glm::dot(normal, a)});
  const facet::Plane& plane = planes_.planes()[found.plane];
  const double sign = found.positive ? 1.0 : -1.0;
  return sign * glm::dvec3(plane.normal.x, plane.normal.y, plane.offset);
}

}  // namespace csgsim::solids
