#include "host/solids/convex_shell.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace csgsim::solids {

namespace {

class Shell {
 public:
  Shell(const Mesh& mesh, const FaceList& faces, const Neighbours& neighbours, const Regions& regions, double near)
      : mesh_(mesh), faces_(faces), neighbours_(neighbours), regions_(regions), near_(near) {}

  [[nodiscard]] bool is_convex() const {
    glm::dvec3 middle(0);
    double count = 0;
    for (const std::uint32_t face : faces_) {
      if (regions_.of_face[face] == none) return false;
      for (const std::uint32_t corner : mesh_.faces[face]) {
        middle += mesh_.points[corner];
        ++count;
      }
    }
    middle /= count;
    const bool is_locally = std::all_of(faces_.begin(), faces_.end(), [&](std::uint32_t face) {
      return face_plane(face).height(middle) < -near_ && holds_neighbours(face);
    });
    return is_locally && std::abs(winding(mesh_, faces_, middle) - 1.0) < 0.5;
  }

  [[nodiscard]] std::optional<model::Polyhedron> polyhedron() const {
    std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> outlines;  // region, corner, next corner
    for (const std::uint32_t face : faces_) {
      const std::vector<std::uint32_t>& corners = mesh_.faces[face];
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t beyond = neighbours_.face[neighbours_.first_side[face] + k];
        if (regions_.of_face[beyond] == regions_.of_face[face]) continue;
        const std::uint32_t next = corners[(k + 1) % corners.size()];
        if (!outlines[regions_.of_face[face]].emplace(corners[k], next).second) return std::nullopt;
      }
    }
    return assemble(outlines);
  }

 private:
  using Outline = std::map<std::uint32_t, std::uint32_t>;

  [[nodiscard]] const facet::Plane& face_plane(std::uint32_t face) const {
    return regions_.planes[regions_.of_face[face]];
  }

  [[nodiscard]] bool holds_neighbours(std::uint32_t face) const {
    for (std::uint32_t side = neighbours_.first_side[face]; side < neighbours_.first_side[face + 1]; ++side) {
      const std::uint32_t beyond = neighbours_.face[side];
      if (beyond == none) return false;
      for (const std::uint32_t corner : mesh_.faces[beyond]) {
        if (face_plane(face).height(mesh_.points[corner]) > near_) return false;
      }
    }
    return true;
  }

  /// Assembles the polyhedron. Omits corners at which only two regions meet, because they lie within an edge.
  [[nodiscard]] std::optional<model::Polyhedron> assemble(const std::map<std::uint32_t, Outline>& outlines) const {
    std::map<std::uint32_t, std::uint32_t> degrees;
    for (const auto& [region, outline] : outlines) {
      for (const auto& [from, to] : outline) ++degrees[from];
    }
    model::Polyhedron made;
    std::map<std::uint32_t, std::uint32_t> places;
    for (const auto& [region, outline] : outlines) {
      std::vector<std::uint32_t> corners;
      std::uint32_t at = outline.begin()->first;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        if (degrees[at] > 2) {
          const auto [place, is_new] = places.try_emplace(at, static_cast<std::uint32_t>(made.points.size()));
          if (is_new) made.points.push_back(mesh_.points[at]);
          corners.push_back(place->second);
        }
        const auto next = outline.find(at);
        if (next == outline.end()) return std::nullopt;
        at = next->second;
        if (at == outline.begin()->first && i + 1 < outline.size()) return std::nullopt;
      }
      if (corners.size() < 3) return std::nullopt;
      made.faces.push_back(std::move(corners));
      const facet::Plane& plane = regions_.planes[region];
      made.planes.emplace_back(plane.normal, plane.offset);
    }
    return made;
  }

  const Mesh& mesh_;
  const FaceList& faces_;
  const Neighbours& neighbours_;
  const Regions& regions_;
  double near_;
};

}  // namespace

std::optional<model::Polyhedron> as_convex(const Mesh& mesh, const FaceList& shell, const Neighbours& neighbours,
                                           const Regions& regions, double near) {
  const Shell checked(mesh, shell, neighbours, regions, near);
  if (!checked.is_convex()) return std::nullopt;
  return checked.polyhedron();
}

}  // namespace csgsim::solids
