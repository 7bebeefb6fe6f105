#include "tests/fuzz/mesh_invariants.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <span>
#include <utility>

#include "host/convex/clip.h"
#include "host/solids/check.h"
#include "host/solids/flat_faces.h"
#include "host/solids/limits.h"
#include "host/solids/pieces.h"
#include "hw/base/text.h"
#include "tests/fuzz/property.h"

namespace csgsim::fuzz {

namespace {

using Face = std::vector<std::uint32_t>;

/// Area and volume in units of the largest coordinate, for numbers of any size.
struct Measure {
  double volume = 0;
  double area = 0;
};

Measure measure(std::span<const glm::dvec3> points, std::span<const Face> faces, double unit) {
  Measure sum;
  if (faces.empty()) return sum;
  const glm::dvec3 origin = points[faces[0][0]] / unit;
  for (const Face& face : faces) {
    const glm::dvec3 first = points[face[0]] / unit - origin;
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const glm::dvec3 second = points[face[k]] / unit - origin;
      const glm::dvec3 third = points[face[k + 1]] / unit - origin;
      sum.volume += glm::dot(first, glm::cross(second, third)) / 6;
      sum.area += glm::length(glm::cross(second - first, third - first)) / 2;
    }
  }
  return sum;
}

void require_closed(std::span<const Face> faces) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> turns;
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t from = face[k];
      const std::uint32_t to = face[(k + 1) % face.size()];
      require(from != to, "no side of a face has zero length");
      turns[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  for (const auto& [edge, turn] : turns) require(turn == 0, "faces use an edge equally often in both directions");
}

void check_piece(const model::Polyhedron& piece, double near) {
  require(piece.points.size() >= 4 && piece.faces.size() >= 4, "a piece has at least four corners and faces");
  require(piece.planes.size() == piece.faces.size(), "each face of a piece has a plane");
  require_closed(piece.faces);
  for (const glm::dvec3& point : piece.points) {
    require(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z), "a piece is bounded");
    for (const glm::dvec4& plane : piece.planes) {
      require(glm::dot(glm::dvec3(plane), point) + plane.w <= near, "a piece is convex");
    }
  }
}

/// The winding number of a closed surface around a point, from its solid angle (van Oosterom and Strackee), unless the
/// point is close to the plane of a triangle.
std::optional<double> winding(const solids::Mesh& mesh, const glm::dvec3& point, double near) {
  double angle = 0;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const glm::dvec3 a = mesh.points[face[0]] - point;
      const glm::dvec3 b = mesh.points[face[k]] - point;
      const glm::dvec3 c = mesh.points[face[k + 1]] - point;
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double six_times = glm::dot(a, glm::cross(b, c));
      if (std::abs(six_times) <= near * glm::length(normal)) return std::nullopt;
      const double la = glm::length(a);
      const double lb = glm::length(b);
      const double lc = glm::length(c);
      angle +=
          2 * std::atan2(six_times, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
  }
  return angle / (4 * std::numbers::pi);
}

bool holds(const model::Polyhedron& piece, const glm::dvec3& point) {
  return std::all_of(piece.planes.begin(), piece.planes.end(),
                     [&](const glm::dvec4& plane) { return glm::dot(glm::dvec3(plane), point) + plane.w <= 0; });
}

/// Checks a self-intersecting mesh: a point is in one piece if the mesh winds around it, and in none otherwise.
void check_enclosed(const solids::Mesh& mesh, const solids::Limits& limits, double unit) {
  const std::vector<model::Polyhedron> pieces = solids::enclosed_pieces(mesh, limits);
  const solids::Mesh flat = solids::with_flat_convex_faces(mesh, limits.tolerance * unit);
  constexpr double far_enough = 1e-3;  // in units of the largest coordinate
  std::mt19937_64 random;
  const auto coordinate = [&] { return unit * (static_cast<double>(random() >> 11U) * 0x1p-52 - 1); };
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 point(coordinate(), coordinate(), coordinate());
    const std::optional<double> turns = winding(flat, point, far_enough * unit);
    if (!turns) continue;
    const auto in = std::count_if(pieces.begin(), pieces.end(), [&](const auto& piece) { return holds(piece, point); });
    require(in == (std::abs(*turns) > 0.5 ? 1 : 0), "the pieces fill the volume that the mesh winds around");
  }
}

/// The convex pieces; empty if the mesh intersects itself.
std::optional<std::vector<model::Polyhedron>> divided(const solids::CheckedMesh& checked,
                                                      const solids::Limits& limits) {
  if (checked.crossing) return std::nullopt;
  try {
    return solids::convex_pieces(checked.mesh, limits);
  } catch (const solids::WindingError&) {
    return std::nullopt;
  }
}

}  // namespace

void check_mesh(const solids::Mesh& mesh, double tolerance) {
  const solids::CheckedMesh checked = solids::check(mesh, tolerance);
  if (checked.defect) {
    require(checked.defect->face < mesh.faces.size(), "a defect is at a face of the mesh");
    require(printable(checked.defect->what) == checked.defect->what,
            "a defect is described in one line of printable text");
    return;
  }
  require_closed(checked.mesh.faces);
  const double unit = solids::largest_coordinate(checked.mesh);
  solids::Limits limits;
  limits.tolerance = tolerance;
  const auto parts = divided(checked, limits);
  if (!parts) return check_enclosed(checked.mesh, limits, unit);
  Measure pieces;
  // Corners are off their planes by at most twice the tolerance, or twice the error of cuts, which is relative to the
  // diagonal; both ends of a distance may be off.
  const double cuts = convex::relative_tolerance * 2 * std::sqrt(3.0);
  const double near = 4 * std::max(tolerance, cuts);
  for (const model::Polyhedron& piece : *parts) {
    check_piece(piece, near * unit);
    const Measure one = measure(piece.points, piece.faces, unit);
    require(one.volume > 0, "the faces of a piece run counter-clockwise seen from outside");
    pieces.volume += one.volume;
  }
  // Faces that are not flat enclose the volume of their triangles.
  const solids::Mesh flat = solids::with_flat_convex_faces(checked.mesh, tolerance * unit);
  const Measure whole = measure(flat.points, flat.faces, unit);
  require(std::abs(pieces.volume - whole.volume) <= near * whole.area, "the pieces fill the whole volume");
}

}  // namespace csgsim::fuzz
