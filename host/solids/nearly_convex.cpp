#include "host/solids/nearly_convex.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "host/solids/flat_faces.h"
#include "host/solids/neighbours.h"

namespace csgsim::solids {

namespace {

/// In degrees.
constexpr double most_dent = 0.1;

double angle_between(const glm::dvec3& one, const glm::dvec3& other) {
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

}  // namespace

bool is_nearly_convex(const Mesh& mesh) {
  const std::vector<std::uint32_t> shells = find_shells(mesh);
  if (std::ranges::any_of(shells, [](std::uint32_t shell) { return shell > 0; })) return false;
  const Neighbours neighbours = find_neighbours(mesh);
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    const std::vector<std::uint32_t>& face = mesh.faces[i];
    const glm::dvec3 here = area_vector(mesh, face);
    for (std::uint32_t k = 0; k < face.size(); ++k) {
      const std::uint32_t beyond = neighbours.face[neighbours.first_side[i] + k];
      if (beyond == none) return false;
      const glm::dvec3 there = area_vector(mesh, mesh.faces[beyond]);
      const glm::dvec3 across = mesh.points[face[(k + 2) % face.size()]] - mesh.points[face[k]];
      if (glm::dot(there, across) > 0 && angle_between(here, there) > glm::radians(most_dent)) return false;
    }
  }
  return true;
}

}  // namespace csgsim::solids
