#include "host/convex/clip.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "host/convex/cutter.h"

namespace csgsim::convex {

namespace {

/// Removes vertices with only two faces left, which merges their edges there, and faces without area.
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

Polytope apply(Polytope polytope, Cut cut, facet::Halfspace halfspace) {
  for (CutFace& cut_face : cut.faces) polytope.faces[cut_face.face].corners = std::move(cut_face.corners);
  polytope.faces.push_back({halfspace, std::move(cut.cap)});
  polytope.vertices.insert(polytope.vertices.end(), cut.added.begin(), cut.added.end());
  drop_flat_corners(polytope);
  drop_unused_vertices(polytope);
  if (polytope.faces.size() < 4) return {};
  return polytope;
}

std::vector<VertexSide> classify_vertices(const std::vector<double>& distances, double near) {
  std::vector<VertexSide> sides;
  sides.reserve(distances.size());
  for (const double distance : distances) {
    sides.push_back(distance < -near ? VertexSide::in : distance > near ? VertexSide::out : VertexSide::on);
  }
  return sides;
}

}  // namespace

double tolerance(const facet::PlaneTable& planes) { return relative_tolerance * planes.diagonal(); }

facet::Plane outward_plane(facet::Halfspace halfspace, const facet::PlaneTable& planes) {
  const facet::Plane& plane = planes.planes()[halfspace.plane];
  return halfspace.positive ? plane : facet::Plane{-plane.normal, -plane.offset};
}

std::uint64_t clip_steps(std::uint64_t vertex_count) {
  constexpr std::uint64_t of_any = 200;
  constexpr std::uint64_t of_vertex = 40;
  return of_any + of_vertex * vertex_count;
}

std::uint64_t clip_steps(const Polytope& polytope) { return clip_steps(polytope.vertices.size()); }

Polytope clip(Polytope polytope, facet::Halfspace halfspace, const facet::PlaneTable& planes) {
  const facet::Plane plane = outward_plane(halfspace, planes);
  std::vector<double> distances;
  distances.reserve(polytope.vertices.size());
  for (const glm::dvec3& vertex : polytope.vertices) distances.push_back(plane.height(vertex));
  if (distances.empty()) return {};
  const auto [deepest, farthest] = std::minmax_element(distances.begin(), distances.end());
  std::vector<std::uint32_t> faces(polytope.faces.size());
  std::iota(faces.begin(), faces.end(), 0U);
  // The loop terminates: no vertex is inside once the tolerance exceeds all distances, or if a distance is not a
  // number.
  for (double times = 1.0;; times = next_tolerance_factor(times)) {
    const double near = times * tolerance(planes);
    if (!(*deepest < -near)) return {};
    if (*farthest <= near) return polytope;
    if (std::optional<Cut> made = cut_faces(polytope, faces, plane, classify_vertices(distances, near)))
      return apply(std::move(polytope), std::move(*made), halfspace);
  }
}

}  // namespace csgsim::convex
