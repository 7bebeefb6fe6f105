#include "host/convex/clip.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

namespace csgsim::convex {

namespace {

enum class Side : std::uint8_t { in, on, out };

/// The tolerances that are tried: 1, parts of it down to where rounding begins, multiples of it.
constexpr double next_tolerance(double times) {
  constexpr double least = 1.0 / 4096;
  if (times == least) return 8.0;
  return times > 1.0 ? times * 8.0 : times / 8.0;
}

using FaceCorners = std::vector<std::uint32_t>;
using DirectedEdge = std::array<std::uint32_t, 2>;

/// What is left of a face that is not wholly in; without corners if that is nothing.
struct CutFace {
  std::size_t face = 0;
  FaceCorners corners;
};

/// How a plane cuts a polytope: what faces become, and the polygon that closes it.
struct Cut {
  std::vector<CutFace> faces;
  std::vector<glm::dvec3> added;
  FaceCorners cap;
};

/// One cut of one polytope. Keeps references to its arguments.
class Cutter {
 public:
  Cutter(const Polytope& polytope, const std::vector<double>& distances, const std::vector<Side>& sides)
      : polytope_(polytope), distances_(distances), sides_(sides) {}

  /// Nothing if the cut is not one polygon.
  std::optional<Cut> operator()() {
    for (std::size_t face = 0; face < polytope_.faces.size(); ++face) {
      if (!cut_face(face)) return std::nullopt;
    }
    if (!close()) return std::nullopt;
    return std::move(cut_);
  }

 private:
  [[nodiscard]] Side side(std::uint32_t vertex) const { return vertex < sides_.size() ? sides_[vertex] : Side::on; }

  /// The vertex where an edge crosses the plane, the same for both faces.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto next = static_cast<std::uint32_t>(polytope_.vertices.size() + cut_.added.size());
    const auto [entry, is_new] = crossings_.try_emplace({low, high}, next);
    if (is_new) {
      const double part = distances_[low] / (distances_[low] - distances_[high]);
      cut_.added.push_back(polytope_.vertices[low] + part * (polytope_.vertices[high] - polytope_.vertices[low]));
    }
    return entry->second;
  }

  /// False if the face leaves the half-space more than once.
  bool cut_face(std::size_t face) {
    const FaceCorners& corners = polytope_.faces[face].corners;
    const auto inside = std::count_if(corners.begin(), corners.end(),
                                      [this](std::uint32_t corner) { return side(corner) == Side::in; });
    if (inside == static_cast<std::ptrdiff_t>(corners.size())) return true;
    FaceCorners& kept = cut_.faces.emplace_back(CutFace{face, {}}).corners;
    if (inside == 0) return true;
    int leaves = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t here = corners[i];
      const std::uint32_t next = corners[(i + 1) % corners.size()];
      const bool here_out = side(here) == Side::out;
      const bool next_out = side(next) == Side::out;
      if (!here_out) kept.push_back(here);
      if (!here_out && next_out) ++leaves;
      if ((side(here) == Side::in && next_out) || (here_out && side(next) == Side::in)) {
        kept.push_back(crossing(here, next));
      }
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const DirectedEdge edge{kept[i], kept[(i + 1) % kept.size()]};
      if (side(edge[0]) == Side::on && side(edge[1]) == Side::on) on_plane_.push_back(edge);
    }
    return leaves <= 1;
  }

  /// The cap runs against the edges that have lost the face on their other side.
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
  const std::vector<double>& distances_;
  const std::vector<Side>& sides_;
  Cut cut_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  std::vector<DirectedEdge> on_plane_;  ///< of what is left of faces
};

/// Takes out vertices that only two faces are left at, whose edges there become one, and faces without area.
void drop_flat_corners(Polytope& polytope) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<std::uint32_t> degrees(polytope.vertices.size(), 0);
    for (const Face& face : polytope.faces) {
      for (const std::uint32_t corner : face.corners) ++degrees[corner];
    }
    for (Face& face : polytope.faces) {
      changed |= std::erase_if(face.corners, [&](std::uint32_t corner) { return degrees[corner] < 3; }) > 0;
    }
    changed |= std::erase_if(polytope.faces, [](const Face& face) { return face.corners.size() < 3; }) > 0;
  }
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

Polytope apply(Polytope polytope, Cut cut, facet::Halfspace halfspace) {
  for (CutFace& cut_face : cut.faces) polytope.faces[cut_face.face].corners = std::move(cut_face.corners);
  polytope.faces.push_back({halfspace, std::move(cut.cap)});
  polytope.vertices.insert(polytope.vertices.end(), cut.added.begin(), cut.added.end());
  drop_flat_corners(polytope);
  drop_unused_vertices(polytope);
  if (polytope.faces.size() < 4) return {};
  return polytope;
}

std::vector<Side> sides_of(const std::vector<double>& distances, double near) {
  std::vector<Side> sides;
  sides.reserve(distances.size());
  for (const double distance : distances) {
    sides.push_back(distance < -near ? Side::in : distance > near ? Side::out : Side::on);
  }
  return sides;
}

}  // namespace

double tolerance(const facet::PlaneTable& planes) { return relative_tolerance * planes.diagonal(); }

facet::Plane outward_plane(facet::Halfspace halfspace, const facet::PlaneTable& planes) {
  const facet::Plane& plane = planes.planes()[halfspace.plane];
  return halfspace.positive ? plane : facet::Plane{-plane.normal, -plane.offset};
}

std::uint64_t clip_steps(const Polytope& polytope) {
  constexpr std::uint64_t of_any = 200;
  constexpr std::uint64_t of_vertex = 40;
  return of_any + of_vertex * polytope.vertices.size();
}

Polytope clip(Polytope polytope, facet::Halfspace halfspace, const facet::PlaneTable& planes) {
  const facet::Plane plane = outward_plane(halfspace, planes);
  std::vector<double> distances;
  distances.reserve(polytope.vertices.size());
  for (const glm::dvec3& vertex : polytope.vertices) distances.push_back(plane.height(vertex));
  if (distances.empty()) return {};
  const auto [deepest, farthest] = std::minmax_element(distances.begin(), distances.end());
  // The loop ends: no vertex is in once the tolerance is beyond all distances, or where a distance is not a number.
  for (double times = 1.0;; times = next_tolerance(times)) {
    const double near = times * tolerance(planes);
    if (!(*deepest < -near)) return {};
    if (*farthest <= near) return polytope;
    if (std::optional<Cut> cut = Cutter(polytope, distances, sides_of(distances, near))()) {
      return apply(std::move(polytope), std::move(*cut), halfspace);
    }
  }
}

}  // namespace csgsim::convex
