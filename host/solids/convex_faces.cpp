#include "host/solids/convex_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/solids/flat_faces.h"
#include "host/solids/limits.h"
#include "host/solids/neighbours.h"

namespace csgsim::solids {

namespace {

constexpr std::uint64_t max_points_times_faces = std::uint64_t{1} << 30U;

/// Rounding error of doubles, in units of the mesh's size.
constexpr double rounding = 1e-12;

/// Maximum angle of a concave edge, in degrees.
constexpr double max_dent_degrees = 0.1;

/// The planes of a mesh's faces; points are scaled to [-1, 1] and centred at the origin.
struct Planes {
  double size = 0;  ///< diagonal of the bounding box
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec3> normals;  ///< unit normals; 0 for a face without area
  std::vector<double> distances;    ///< normal · point on the plane
  std::vector<double> areas;

  /// Maximum distance of a point from its face.
  [[nodiscard]] double tolerance() const { return std::min(printed_tolerance, max_tolerance * size); }

  /// Distance of a point from the plane of a face, positive outside the mesh.
  [[nodiscard]] double height(std::size_t face, std::uint32_t point) const {
    return glm::dot(normals[face], points[point]) - distances[face];
  }
};

Mesh scaled(const Mesh& mesh, double& size) {
  Mesh made = mesh;
  const double scale = largest_coordinate(mesh);
  for (glm::dvec3& point : made.points) point /= scale;
  const facet::Box box = facet::box_of(made.points);
  for (glm::dvec3& point : made.points) point -= box.centre();
  size = box.diagonal();
  return made;
}

/// Fits planes with Newell's normal through the mean of the corners.
Planes fit_planes(const Mesh& mesh) {
  Planes planes;
  const Mesh made = scaled(mesh, planes.size);
  for (const auto& face : made.faces) {
    const glm::dvec3 vector = area_vector(made, face);
    const double twice_area = glm::length(vector);
    const glm::dvec3& origin = made.points[face.front()];
    glm::dvec3 mean(0);
    double reach = 0;
    for (const std::uint32_t corner : face) {
      mean += (made.points[corner] - origin) / static_cast<double>(face.size());
      reach = std::max(reach, glm::length(made.points[corner] - origin));
    }
    const bool has_area = twice_area > rounding * reach * reach;
    planes.normals.push_back(has_area ? vector / twice_area : glm::dvec3(0));
    planes.distances.push_back(glm::dot(planes.normals.back(), mean + origin));
    planes.areas.push_back(twice_area / 2);
  }
  planes.points = made.points;
  return planes;
}

/// Whether all points are in one plane, within the rounding of doubles.
bool is_flat(const Planes& planes) {
  const auto largest = std::ranges::max_element(planes.areas) - planes.areas.begin();
  for (std::uint32_t i = 0; i < planes.points.size(); ++i) {
    if (std::abs(planes.height(static_cast<std::size_t>(largest), i)) > rounding * planes.size) return false;
  }
  return true;
}

/// Reverses all faces if they run clockwise as seen from outside.
void turn_outwards(Mesh& mesh, Planes& planes) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) volume += planes.areas[i] * planes.distances[i];
  if (volume >= 0) return;
  for (auto& face : mesh.faces) std::ranges::reverse(face);
  for (glm::dvec3& normal : planes.normals) normal = -normal;
  for (double& distance : planes.distances) distance = -distance;
}

bool are_flat(const std::vector<std::vector<std::uint32_t>>& faces, const Planes& planes) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto is_off = [&](std::uint32_t corner) { return std::abs(planes.height(i, corner)) > planes.tolerance(); };
    if (std::ranges::any_of(faces[i], is_off)) return false;
  }
  return true;
}

bool is_dented(const Planes& planes) {
  for (std::size_t i = 0; i < planes.normals.size(); ++i) {
    for (std::uint32_t point = 0; point < planes.points.size(); ++point) {
      if (planes.height(i, point) > planes.tolerance()) return true;
    }
  }
  return false;
}

double angle_between(const glm::dvec3& one, const glm::dvec3& other) {
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

}  // namespace

std::optional<model::Polyhedron> as_convex_faces(Mesh mesh) {
  if (mesh.faces.empty() || std::uint64_t{mesh.points.size()} * mesh.faces.size() > max_points_times_faces) {
    return std::nullopt;
  }
  if (std::ranges::count(find_neighbours(mesh).face, none) > 0) return std::nullopt;
  Planes planes = fit_planes(mesh);
  if (is_flat(planes) || std::ranges::count(planes.normals, glm::dvec3(0)) > 0) return std::nullopt;
  turn_outwards(mesh, planes);
  if (!are_flat(mesh.faces, planes) || is_dented(planes)) return std::nullopt;
  return model::Polyhedron{std::move(mesh.points), std::move(mesh.faces)};
}

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
      if (glm::dot(there, across) > 0 && angle_between(here, there) > glm::radians(max_dent_degrees)) return false;
    }
  }
  return true;
}

}  // namespace csgsim::solids
