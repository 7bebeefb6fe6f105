#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace csgsim::testing {

/// A polygon mesh, as OpenSCAD exports it.
struct Mesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<unsigned>> faces;  ///< convex polygons or triangles
};

/// Reads an OFF file. Throws std::runtime_error if it is none.
Mesh read_off(const std::string& path);

}  // namespace csgsim::testing
