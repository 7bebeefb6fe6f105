#include "host/flat/svg/arc.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "host/model/degrees.h"

namespace csgsim::flat::svg {

namespace {

/// Degrees in the range [0, 360).
double polar_angle(const glm::dvec2& direction) {
  const double angle = std::atan2(direction.y, direction.x) * 180 / std::numbers::pi;
  return angle < 0 ? angle + 360 : angle;
}

}  // namespace

// The centre follows appendix B.2.4 of SVG 1.1's implementation notes: in the space in which the ellipse is the unit
// circle, it lies on the perpendicular bisector of the chord.
void add_arc(Outline& outline, const Arc& arc) {
  const glm::dvec2 radii = glm::abs(arc.radii);
  if (arc.from == arc.to) return;
  if (radii.x == 0 || radii.y == 0) {
    outline.push_back(arc.to);
    return;
  }
  const double sine = model::sin_degrees(arc.turn);
  const double cosine = model::cos_degrees(arc.turn);
  const glm::dmat2 turn(cosine, sine, -sine, cosine);
  const glm::dvec2 half = glm::transpose(turn) * (arc.from - arc.to) / 2.0 / radii;
  const double enlarged = std::max(1.0, glm::length(half));
  const glm::dvec2 start = half / enlarged;
  const double reach = glm::dot(start, start);
  const double aside = std::sqrt(std::max(0.0, 1 - reach) / reach) * (arc.large == arc.sweep ? -1 : 1);
  const glm::dvec2 centre = aside * glm::dvec2(start.y, -start.x);

  const double first = polar_angle(start - centre);
  double delta = polar_angle(-start - centre) - first;
  if (delta < 0) delta += 360;
  if (!arc.sweep) delta -= 360;
  const int steps = static_cast<int>(std::abs(delta) * 10 / 180) + 4;
  const glm::dvec2 middle = (arc.from + arc.to) / 2.0;
  for (int i = 0; i <= steps; ++i) {
    const double angle = first + delta * i / steps;
    const glm::dvec2 point(model::cos_degrees(angle), model::sin_degrees(angle));
    outline.push_back(middle + turn * (enlarged * radii * (centre + point)));
  }
}

}  // namespace csgsim::flat::svg
