#include "tests/unit/convert/mesh_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

namespace csgsim::testing {

namespace {

using Ends = std::pair<std::uint32_t, std::uint32_t>;

std::map<Ends, int> sides_of(const JudgedMesh& mesh) {
  std::map<Ends, int> sides;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i) ++sides[{face[i], face[(i + 1) % face.size()]}];
  return sides;
}

std::string unequal_side(const JudgedMesh& mesh, bool is_once) {
  const std::map<Ends, int> sides = sides_of(mesh);
  for (const auto& [ends, times] : sides) {
    const auto back = sides.find({ends.second, ends.first});
    const int backs = back == sides.end() ? 0 : back->second;
    if (times != backs || (is_once && times != 1))
      return fmt::format("side {}-{} occurs {} times and its reverse {} times", ends.first, ends.second, times, backs);
  }
  return "";
}

glm::dvec3 normal_of(const JudgedMesh& mesh, const std::vector<std::uint32_t>& face) {
  glm::dvec3 sum(0);
  const glm::dvec3 first = mesh.points[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    sum += glm::cross(mesh.points[face[i]] - first, mesh.points[face[i + 1]] - first);
  return glm::normalize(sum);
}

/// A point closer than `near` to the interior of an edge.
std::string point_on_edge(const JudgedMesh& mesh, double near) {
  std::map<Ends, glm::dvec3> normals;
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      normals[{face[i], face[(i + 1) % face.size()]}] = normal_of(mesh, face);
  for (const auto& [ends, normal] : normals) {
    if (ends.first > ends.second || glm::dot(normal, normals.at({ends.second, ends.first})) > 1 - 1e-12) continue;
    const glm::dvec3 from = mesh.points[ends.first];
    const glm::dvec3 way = mesh.points[ends.second] - from;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const double along = glm::dot(mesh.points[i] - from, way) / glm::dot(way, way);
      const bool is_between = along * glm::length(way) > near && (1 - along) * glm::length(way) > near;
      if (is_between && glm::distance(mesh.points[i], from + along * way) < near)
        return fmt::format("point {} lies on side {}-{}", i, ends.first, ends.second);
    }
  }
  return "";
}

double size_of(const JudgedMesh& mesh) {
  double size = 0;
  for (const glm::dvec3& point : mesh.points) size = std::max(size, glm::distance(point, mesh.points.front()));
  return size;
}

}  // namespace

std::string fault_of(const JudgedMesh& mesh) {
  for (const auto& face : mesh.faces)
    if (face.size() < 3 || std::set(face.begin(), face.end()).size() != face.size())
      return "a face has a repeated corner or fewer than three";
  const std::string unequal = unequal_side(mesh, true);
  return unequal.empty() ? point_on_edge(mesh, 1e-11 * size_of(mesh)) : unequal;
}

std::string sides_fault_of(const JudgedMesh& mesh) { return unequal_side(mesh, true); }

std::string welded_fault_of(const JudgedMesh& mesh) {
  std::map<std::tuple<double, double, double>, std::uint32_t> numbers;
  JudgedMesh welded{mesh.points, {}};
  for (auto face : mesh.faces) {
    for (std::uint32_t& corner : face) {
      const glm::dvec3& point = mesh.points[corner];
      corner = numbers.try_emplace({point.x, point.y, point.z}, corner).first->second;
    }
    welded.faces.push_back(std::move(face));
  }
  return unequal_side(welded, false);
}

double volume_of(const JudgedMesh& mesh) {
  using Vector = glm::tvec3<long double>;
  long double sum = 0;
  for (const auto& face : mesh.faces) {
    const Vector middle(mesh.points.front());
    const Vector first = Vector(mesh.points[face[0]]) - middle;
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      sum +=
          glm::dot(first, glm::cross(Vector(mesh.points[face[i]]) - middle, Vector(mesh.points[face[i + 1]]) - middle));
    }
  }
  return static_cast<double>(sum / 6);
}

int winding(const JudgedMesh& mesh, const glm::dvec3& point) {
  double sum = 0;
  for (const auto& face : mesh.faces) {
    const glm::dvec3 a = glm::normalize(mesh.points[face[0]] - point);
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const glm::dvec3 b = glm::normalize(mesh.points[face[i]] - point);
      const glm::dvec3 c = glm::normalize(mesh.points[face[i + 1]] - point);
      // Source: A. van Oosterom and J. Strackee, "The solid angle of a plane triangle", 1983.
      sum += 2 * std::atan2(glm::dot(a, glm::cross(b, c)), 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    }
  }
  return static_cast<int>(std::lround(sum / (4 * std::numbers::pi)));
}

std::size_t part_count(const JudgedMesh& mesh) {
  std::map<Ends, std::size_t> face_at;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const auto& corners = mesh.faces[face];
    for (std::size_t i = 0; i < corners.size(); ++i) face_at[{corners[i], corners[(i + 1) % corners.size()]}] = face;
  }
  std::vector<bool> is_seen(mesh.faces.size(), false);
  std::size_t parts = 0;
  for (std::size_t first = 0; first < mesh.faces.size(); ++first) {
    if (is_seen[first]) continue;
    ++parts;
    std::vector<std::size_t> open{first};
    is_seen[first] = true;
    while (!open.empty()) {
      const auto& corners = mesh.faces[open.back()];
      open.pop_back();
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto next = face_at.find({corners[(i + 1) % corners.size()], corners[i]});
        if (next == face_at.end() || is_seen[next->second]) continue;
        is_seen[next->second] = true;
        open.push_back(next->second);
      }
    }
  }
  return parts;
}

}  // namespace csgsim::testing
