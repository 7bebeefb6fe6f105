// A polygon mesh.
// Used throughout host/solids and by host/read and host/swept.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace csgsim::solids {

/// The surface of a solid: faces with three or more corners each, which index `points` and run counter-clockwise as
/// seen from outside. The surface may be open or intersect itself; check.h tests for both.
struct Mesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

}  // namespace csgsim::solids
