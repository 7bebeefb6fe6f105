// 2-D areas bounded by polygons.
// Used throughout host/flat and by host/read and host/solids.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace csgsim::flat {

/// A closed polygon; the last corner is joined to the first.
using Outline = std::vector<glm::dvec2>;

/// A bounded part of the x, y plane, enclosed by its outlines. Outer outlines run counter-clockwise and holes
/// clockwise. Outlines may touch, but cross neither each other nor themselves. An area without outlines is empty.
struct Area {
  std::vector<Outline> outlines;

  [[nodiscard]] bool empty() const { return outlines.empty(); }
};

}  // namespace csgsim::flat
