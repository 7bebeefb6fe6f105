#include "host/convex/cutter.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace csgsim::convex {

namespace {

using DirectedEdge = std::array<std::uint32_t, 2>;

/// One cut of one polytope. Keeps references to its arguments.
class Cutter {
 public:
  Cutter(const Polytope& polytope, const facet::Plane& plane, const std::vector<VertexSide>& sides)
      : polytope_(polytope), plane_(plane), sides_(sides) {}

  std::optional<Cut> operator()(std::span<const std::uint32_t> faces) {
    for (const std::uint32_t face : faces) {
      if (!cut_face(face)) return std::nullopt;
    }
    if (!close()) return std::nullopt;
    return std::move(cut_);
  }

 private:
  [[nodiscard]] VertexSide side(std::uint32_t vertex) const {
    return vertex < sides_.size() ? sides_[vertex] : VertexSide::on;
  }

  /// The vertex at which an edge crosses the plane; both faces of the edge share it.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto next = static_cast<std::uint32_t>(polytope_.vertices.size() + cut_.added.size());
    const auto [entry, is_new] = crossings_.try_emplace({low, high}, next);
    if (is_new) {
      const double at_low = plane_.height(polytope_.vertices[low]);
      const double part = at_low / (at_low - plane_.height(polytope_.vertices[high]));
      cut_.added.push_back(polytope_.vertices[low] + part * (polytope_.vertices[high] - polytope_.vertices[low]));
    }
    return entry->second;
  }

  /// Returns false if the face leaves the half-space more than once.
  bool cut_face(std::uint32_t face) {
    const FaceCorners& corners = polytope_.faces[face].corners;
    const auto inside = std::count_if(corners.begin(), corners.end(),
                                      [this](std::uint32_t corner) { return side(corner) == VertexSide::in; });
    if (inside == static_cast<std::ptrdiff_t>(corners.size())) return true;
    FaceCorners& kept = cut_.faces.emplace_back(CutFace{face, {}}).corners;
    if (inside == 0) return true;
    int leaves = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t here = corners[i];
      const std::uint32_t next = corners[(i + 1) % corners.size()];
      const bool here_out = side(here) == VertexSide::out;
      const bool next_out = side(next) == VertexSide::out;
      if (!here_out) kept.push_back(here);
      if (!here_out && next_out) ++leaves;
      if ((side(here) == VertexSide::in && next_out) || (here_out && side(next) == VertexSide::in)) {
        kept.push_back(crossing(here, next));
      }
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const DirectedEdge edge{kept[i], kept[(i + 1) % kept.size()]};
      if (side(edge[0]) == VertexSide::on && side(edge[1]) == VertexSide::on) on_plane_.push_back(edge);
    }
    return leaves <= 1;
  }

  /// Builds the cap. It runs opposite to the edges whose face on the other side was lost.
  bool close() {
    std::sort(on_plane_.begin(), on_plane_.end());
    if (std::adjacent_find(on_plane_.begin(), on_plane_.end()) != on_plane_.end()) return false;
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [from, to] : on_plane_) {
      if (std::binary_search(on_plane_.begin(), on_plane_.end(), DirectedEdge{to, from})) continue;
      if (!next.emplace(to, from).second) return false;
    }
    if (next.size() < 3) return false;
    std::uint32_t at = next.begin()->first;
    do {
      cut_.cap.push_back(at);
      const auto found = next.find(at);
      if (found == next.end() || cut_.cap.size() > next.size()) return false;
      at = found->second;
    } while (at != cut_.cap.front());
    return cut_.cap.size() == next.size();
  }

  const Polytope& polytope_;
  const facet::Plane& plane_;
  const std::vector<VertexSide>& sides_;
  Cut cut_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  std::vector<DirectedEdge> on_plane_;  ///< edges of the remaining faces in the plane
};

}  // namespace

double next_tolerance_factor(double factor) {
  constexpr double least = 1.0 / 4096;
  if (factor == least) return 8.0;
  return factor > 1.0 ? factor * 8.0 : factor / 8.0;
}

std::optional<Cut> cut_faces(const Polytope& polytope, std::span<const std::uint32_t> faces, const facet::Plane& plane,
                             const std::vector<VertexSide>& sides) {
  return Cutter(polytope, plane, sides)(faces);
}

void drop_unused_vertices(Polytope& polytope) {
  std::vector<std::uint32_t> places(polytope.vertices.size(), 0);
  for (const Face& face : polytope.faces) {
    for (const std::uint32_t corner : face.corners) places[corner] = 1;
  }
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] == 0) continue;
    polytope.vertices[count] = polytope.vertices[i];
    places[i] = count++;
  }
  polytope.vertices.resize(count);
  for (Face& face : polytope.faces) {
    for (std::uint32_t& corner : face.corners) corner = places[corner];
  }
}

}  // namespace csgsim::convex
