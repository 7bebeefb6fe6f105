#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace csgsim::testing {

/// Polygon mesh as exported by OpenSCAD.
struct Mesh {
  std::vector<glm::dvec3> points;
  std::vector<std::vector<unsigned>> faces;  ///< convex polygons or triangles
};

/// Reads an OFF file. Throws std::runtime_error if the file is not in that format.
Mesh read_off(const std::string& path);

}  // namespace csgsim::testing
