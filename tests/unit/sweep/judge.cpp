#include "tests/unit/sweep/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace csgsim::testing {

namespace {

constexpr double rounding = 1e-8;

template <class Solid, class Visit>
void for_triangles(const Solid& solid, const Visit& visit) {
  for (const auto& face : solid.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      visit(solid.points[face[0]], solid.points[face[i]], solid.points[face[i + 1]]);
    }
  }
}

template <class Solid>
double volume_of(const Solid& solid) {
  double six_times = 0;
  for_triangles(solid, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    six_times += glm::dot(a, glm::cross(b, c));
  });
  return six_times / 6.0;
}

double height(const glm::dvec4& plane, const glm::dvec3& point) { return glm::dot(glm::dvec3(plane), point) + plane.w; }

}  // namespace

double volume(const Mesh& mesh) { return volume_of(mesh); }
double volume(const model::Polyhedron& piece) { return volume_of(piece); }

double winding(const Mesh& mesh, const glm::dvec3& point) {
  double angle = 0;
  for_triangles(mesh, [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    const glm::dvec3 a = glm::normalize(p - point);
    const glm::dvec3 b = glm::normalize(q - point);
    const glm::dvec3 c = glm::normalize(r - point);
    angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
  });
  return angle / (4.0 * std::numbers::pi);
}

Membership membership(const model::Polyhedron& piece, const glm::dvec3& point) {
  Membership result{std::numeric_limits<double>::infinity(), true};
  for (const glm::dvec4& plane : piece.planes) {
    result.nearest = std::min(result.nearest, std::abs(height(plane, point)));
    result.inside = result.inside && height(plane, point) <= 0.0;
  }
  return result;
}

std::string fault(const model::Polyhedron& piece) {
  if (piece.planes.size() != piece.faces.size()) return "a face without a plane";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < piece.faces.size(); ++i) {
    const std::vector<std::uint32_t>& face = piece.faces[i];
    const glm::dvec4& plane = piece.planes[i];
    if (std::abs(glm::length(glm::dvec3(plane)) - 1.0) > rounding) return "a normal not of length 1";
    glm::dvec3 area(0);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t next = face[(k + 1) % face.size()];
      ++edges[{face[k], next}];
      --edges[{next, face[k]}];
      area += glm::cross(piece.points[face[k]], piece.points[next]);
      if (std::abs(height(plane, piece.points[face[k]])) > rounding) return "a corner off its face's plane";
    }
    if (!(glm::dot(area, glm::dvec3(plane)) > 0.0)) return fmt::format("face {} runs clockwise", i);
    for (const glm::dvec3& point : piece.points) {
      if (height(plane, point) > rounding) return fmt::format("a corner {} beyond a plane", height(plane, point));
    }
  }
  for (const auto& [edge, times] : edges) {
    if (times != 0) return "an edge without a face on either side";
  }
  return {};
}

}  // namespace csgsim::testing
