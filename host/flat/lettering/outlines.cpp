#include "host/flat/lettering/outlines.h"

#include <array>

#include FT_OUTLINE_H

namespace csgsim::flat::lettering {

namespace {

/// Collects the outlines that FreeType passes to the callbacks.
struct Pen {
  Area area;
  std::uint32_t sides_per_curve = 1;

  [[nodiscard]] Outline& outline() { return area.outlines.back(); }
};

Pen& pen(void* user) { return *static_cast<Pen*>(user); }

glm::dvec2 point(const FT_Vector* vector) { return {static_cast<double>(vector->x), static_cast<double>(vector->y)}; }

int move_to(const FT_Vector* to, void* user) {
  pen(user).area.outlines.push_back({point(to)});
  return 0;
}

int line_to(const FT_Vector* to, void* user) {
  pen(user).outline().push_back(point(to));
  return 0;
}

/// Adds a Bézier curve from the last corner, by de Casteljau's algorithm.
template <std::size_t Count>
int curve_to(Pen& pen, const std::array<const FT_Vector*, Count>& controls) {
  std::array<glm::dvec2, Count + 1> start{pen.outline().back()};
  for (std::size_t i = 0; i < Count; ++i) start[i + 1] = point(controls[i]);
  for (std::uint32_t side = 1; side <= pen.sides_per_curve; ++side) {
    const double t = static_cast<double>(side) / pen.sides_per_curve;
    std::array<glm::dvec2, Count + 1> points = start;
    for (std::size_t left = Count; left > 0; --left) {
      for (std::size_t i = 0; i < left; ++i) points[i] = points[i] * (1 - t) + points[i + 1] * t;
    }
    pen.outline().push_back(points[0]);
  }
  return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
  return curve_to<2>(pen(user), {control, to});
}

int cubic_to(const FT_Vector* control, const FT_Vector* other, const FT_Vector* to, void* user) {
  return curve_to<3>(pen(user), {control, other, to});
}

}  // namespace

Area outlines(FT_Outline& outline, std::uint32_t sides_per_curve) {
  constexpr FT_Outline_Funcs functions{move_to, line_to, conic_to, cubic_to, 0, 0};
  Pen drawn{{}, sides_per_curve};
  FT_Outline_Decompose(&outline, &functions, &drawn);
  return drawn.area;
}

}  // namespace csgsim::flat::lettering
