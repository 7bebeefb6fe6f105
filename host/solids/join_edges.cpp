#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "host/solids/check.h"

namespace csgsim::solids {

namespace {

using Face = std::vector<std::uint32_t>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Edges along which no face runs in the opposite direction.
std::set<Edge> unjoined_edges(const Mesh& mesh) {
  std::vector<std::pair<Edge, int>> sides;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const auto [low, high] = std::minmax(face[k], face[k + 1 < face.size() ? k + 1 : 0]);
      if (low == high) continue;
      sides.push_back({{low, high}, face[k] == low ? 1 : -1});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::set<Edge> found;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    const auto [low, high] = sides[begin].first;
    int surplus = 0;
    for (; end < sides.size() && sides[end].first == sides[begin].first; ++end) surplus += sides[end].second;
    if (surplus > 0) found.insert({low, high});
    if (surplus < 0) found.insert({high, low});
  }
  return found;
}

/// Finds, for each point to be joined, the first point near it; this may be the point itself.
class Nearest {
 public:
  Nearest(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {}

  /// The first added point near this point; if there is none, adds this point.
  std::uint32_t first_near(std::uint32_t point) {
    const Cell at = cell_of(mesh_.points[point]);
    std::uint32_t first = point;
    for (const double x : beside) {
      for (const double y : beside) {
        for (const double z : beside) first = std::min(first, first_in({at[0] + x, at[1] + y, at[2] + z}, point));
      }
    }
    if (first == point) cells_[at].push_back(point);
    return first;
  }

 private:
  static constexpr std::array<double, 3> beside = {-1, 0, 1};

  /// Cell coordinates, which are integers: points near each other are in the same or in adjacent cells. From 2^53 on,
  /// adjacent doubles differ by more than the tolerance, so only equal points are near each other, and these share a
  /// cell.
  using Cell = std::array<double, 3>;

  [[nodiscard]] Cell cell_of(const glm::dvec3& point) const {
    const glm::dvec3 cell = glm::floor(point / (2 * tolerance_));
    return {cell.x, cell.y, cell.z};
  }

  [[nodiscard]] std::uint32_t first_in(const Cell& cell, std::uint32_t point) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return point;
    const auto first = std::ranges::find_if(found->second, [&](std::uint32_t other) {
      return glm::distance(mesh_.points[other], mesh_.points[point]) <= tolerance_;
    });
    return first == found->second.end() ? point : *first;
  }

  const Mesh& mesh_;
  double tolerance_;
  std::map<Cell, std::vector<std::uint32_t>> cells_;  ///< added points, in ascending order
};

class EdgeJoiner {
 public:
  EdgeJoiner(Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance), open_(unjoined_edges(mesh)) {}

  void operator()() {
    if (open_.empty()) return;
    for (Face& face : mesh_.faces) {
      Face made;
      for (std::size_t k = 0; k < face.size(); ++k) {
        made.push_back(face[k]);
        const Face between = corners_on({face[k], face[(k + 1) % face.size()]});
        made.insert(made.end(), between.begin(), between.end());
      }
      face = std::move(made);
    }
  }

 private:
  /// The corners of a chain of other faces' edges that leads from the end of the edge back to its start. They are
  /// returned in the direction of the edge.
  [[nodiscard]] Face corners_on(const Edge& edge) const {
    if (!open_.contains(edge)) return {};
    Face corners;
    std::uint32_t at = edge.second;
    while (const std::optional<std::uint32_t> next = next_on(edge, at)) {
      at = *next;
      if (at == edge.first) {
        std::reverse(corners.begin(), corners.end());
        return corners;
      }
      corners.push_back(at);
    }
    return {};
  }

  /// The end of an open edge that starts at `at`, if that end lies on the given edge and is closer to its start;
  /// otherwise empty.
  [[nodiscard]] std::optional<std::uint32_t> next_on(const Edge& edge, std::uint32_t at) const {
    const glm::dvec3& origin = mesh_.points[edge.first];
    const glm::dvec3 along = glm::normalize(mesh_.points[edge.second] - origin);
    const double place = glm::dot(mesh_.points[at] - origin, along);
    for (auto found = open_.lower_bound({at, 0}); found != open_.end() && found->first == at; ++found) {
      const glm::dvec3 offset = mesh_.points[found->second] - origin;
      const double next = glm::dot(offset, along);
      const bool is_on = glm::length(offset - next * along) <= tolerance_;
      if (is_on && next < place && (next > 0 || found->second == edge.first)) return found->second;
    }
    return std::nullopt;
  }

  Mesh& mesh_;
  double tolerance_;
  std::set<Edge> open_;
};

}  // namespace

void join_near_points(NumberedMesh& numbered, double tolerance) {
  if (tolerance <= 0) return;
  std::set<std::uint32_t> ends;
  for (const auto& [from, to] : unjoined_edges(numbered.mesh)) ends.insert({from, to});
  Nearest nearest(numbered.mesh, tolerance);
  Mesh moved = numbered.mesh;
  for (const std::uint32_t end : ends) moved.points[end] = numbered.mesh.points[nearest.first_near(end)];
  if (moved.points == numbered.mesh.points) return;
  NumberedMesh joined = join_points(moved);
  for (std::uint32_t& number : joined.point_numbers) number = numbered.point_numbers[number];
  for (std::uint32_t& number : joined.face_numbers) number = numbered.face_numbers[number];
  numbered = std::move(joined);
}

void join_edges(NumberedMesh& numbered, double tolerance) { EdgeJoiner(numbered.mesh, tolerance)(); }

}  // namespace csgsim::solids
