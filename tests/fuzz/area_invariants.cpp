#include "tests/fuzz/area_invariants.h"

#include <cmath>

#include "host/flat/parts.h"
#include "tests/fuzz/property.h"

namespace csgsim::fuzz {

namespace {

/// An outline's signed area, and its length.
struct Measure {
  double area = 0;
  double around = 0;
};

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

Measure measure(const flat::Outline& outline) {
  Measure result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 from = outline[i] - outline[0];
    const glm::dvec2 to = outline[(i + 1) % outline.size()] - outline[0];
    result.area += cross(from, to) / 2;
    result.around += std::hypot(to.x - from.x, to.y - from.y);
  }
  return result;
}

void check_convex(const flat::Outline& part) {
  const std::size_t count = part.size();
  require(count >= 3, "a part has at least three corners");
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 in = part[(i + 1) % count] - part[i];
    const glm::dvec2 out = part[(i + 2) % count] - part[(i + 1) % count];
    const double rounding = 1e-12 * (std::hypot(in.x, in.y) * std::hypot(out.x, out.y));
    require(cross(in, out) >= -rounding, "a part is convex");
  }
}

}  // namespace

void check_area(const flat::Area& area) {
  Measure whole;
  for (const flat::Outline& outline : area.outlines) {
    for (const glm::dvec2& corner : outline) {
      require(std::isfinite(corner.x) && std::isfinite(corner.y), "corners are finite");
    }
    const Measure one = measure(outline);
    whole.area += one.area;
    whole.around += one.around;
  }
  double covered = 0;
  for (const flat::Outline& part : flat::convex_parts(area)) {
    check_convex(part);
    covered += measure(part).area;
  }
  // Corners are multiples of 2^-16, and those within 1.4 units of the line of their neighbours are removed, so outlines
  // may cross by that distance.
  constexpr double unit = 1.0 / 65536;
  require(std::abs(covered - whole.area) <= 4 * unit * whole.around + 1e-9 * std::abs(whole.area),
          "the parts cover the whole area");
}

}  // namespace csgsim::fuzz
