#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace csgsim::read {

using Face = std::vector<std::uint32_t>;  ///< indices of points, around the face

/// A polyhedron with each point once, each used, and no face that repeats a corner in a row.
struct Mesh {
  std::vector<glm::dvec3> points;
  std::vector<Face> faces;
  std::vector<std::uint32_t> point_numbers;  ///< of each point, its index in the file
  std::vector<std::uint32_t> face_numbers;   ///< of each face, its index in the file
};

/// What keeps a polyhedron from being used, and the face (its index in the file) to point at.
struct Defect {
  std::size_t face;
  std::string what;
};

/// Joins equal points, drops unused ones, and drops faces that collapse to an edge or a point by that.
Mesh make_mesh(const std::vector<glm::dvec3>& points, const std::vector<Face>& faces);

/// An edge that two faces do not run along once in each direction.
std::optional<Defect> find_open_edge(const Mesh& mesh);

}  // namespace csgsim::read
