#include "sim/software/convert/flat_rounds.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "sim/software/convert/side.h"
#include "sim/software/convert/triangulate.h"

namespace csgsim::software::convert {

Rounds flat_rounds(const Surface& surface) {
  // Plates reach from z = -0.5 to 0.5.
  const auto is_upper = [&](std::uint32_t corner) { return surface.points[corner].z > 0; };
  Outline outline;
  for (const Triangle& corners : surface.triangles) {
    if (!std::ranges::all_of(corners, is_upper)) continue;
    for (std::size_t i = 0; i < 3; ++i) outline.sides.push_back({corners[i], corners[(i + 1) % 3]});
  }
  cancel_opposite_sides(outline.sides);
  Rounds rounds;
  for (const std::vector<std::uint32_t>& round : rounds_of(outline)) {
    std::vector<glm::dvec2>& points = rounds.emplace_back();
    for (const std::uint32_t corner : round) points.emplace_back(surface.points[corner]);
  }
  return rounds;
}

double area_of(const Rounds& rounds) {
  double twice = 0;
  for (const std::vector<glm::dvec2>& round : rounds) {
    const glm::dvec2 first = round.front();
    for (std::size_t i = 1; i + 1 < round.size(); ++i) {
      const glm::dvec2 one = round[i] - first;
      const glm::dvec2 other = round[i + 1] - first;
      twice += one.x * other.y - one.y * other.x;
    }
  }
  return twice / 2;
}

}  // namespace csgsim::software::convert
