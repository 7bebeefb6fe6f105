#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/facet/planes.h"
#include "host/flat/area.h"

namespace csgsim::solids {

/// Below 0 for a hole, which runs clockwise.
double signed_area(const flat::Outline& outline);

/// The lines of a profile's sides: sides on one line, on whichever side of it their parts are, say it in the same
/// numbers.
class SideLines {
 public:
  explicit SideLines(const flat::Area& area);

  /// (normal, offset) with normal . p + offset = 0 on the line; the normal is to the right of the way from `a` to `b`,
  /// of length 1.
  glm::dvec3 operator()(const glm::dvec2& a, const glm::dvec2& b);

 private:
  facet::PlaneTable planes_;
};

}  // namespace csgsim::solids
