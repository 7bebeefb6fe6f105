#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace csgsim::solids {

/// The surface of a solid: faces of three or more corners each, which index `points` and run counter-clockwise as seen
/// from outside. Whether it is closed and does not meet itself is another matter.
struct Mesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

}  // namespace csgsim::solids
