#include "host/solids/pieces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "host/convex/clip.h"
#include "host/convex/merge.h"
#include "host/facet/geometry.h"
#include "host/solids/convex_shell.h"
#include "host/solids/enclosed.h"
#include "host/solids/flat_faces.h"
#include "host/solids/partition.h"
#include "host/solids/polyhedra.h"
#include "host/solids/regions.h"
#include "host/solids/shells.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

/// Minimum number of reflex sides in a level; an edge has two sides.
constexpr std::ptrdiff_t min_sides_in_level = 8;

double mesh_tolerance(const Mesh& mesh, const facet::Box& box, const Limits& limits) {
  return std::min(limits.tolerance * largest_coordinate(mesh), max_tolerance * box.diagonal());
}

class Division {
 public:
  Division(const Mesh& mesh, const facet::Box& box, const Limits& limits)
      : mesh_(with_flat_convex_faces(mesh, mesh_tolerance(mesh, box, limits))),
        limits_(limits),
        neighbours_(find_neighbours(mesh_)),
        regions_(find_regions(mesh_, neighbours_, mesh_tolerance(mesh, box, limits), limits.work)),
        planes_(box.centre(), box.diagonal()),
        near_(2.0 * std::max(regions_.deviation, convex::tolerance(planes_))) {
    for (const facet::Plane& plane : regions_.planes) halfspaces_.push_back(planes_.add(plane));
  }

  std::vector<model::Polyhedron> operator()() {
    for (const FaceList& solid : collect_solids(mesh_, limits_.work)) divide(solid);
    return std::move(pieces_);
  }

  /// Treats all faces as one surface, which may cross itself.
  std::vector<model::Polyhedron> enclosed_pieces() {
    FaceList all(mesh_.faces.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<convex::Polytope> polytopes = enclosed(make_soup(all), make_cell(all), planes_, near_, limits_);
    convex::merge(polytopes, planes_, limits_.work);
    for (const convex::Polytope& polytope : polytopes) pieces_.push_back(to_polyhedron(polytope, planes_));
    return std::move(pieces_);
  }

  /// Whether the volume of the pieces equals that of the solids, within the error that corners off their planes may
  /// cause.
  [[nodiscard]] bool keeps_volume() const { return std::abs(gain_) <= near_ * area_; }

 private:
  void divide(const FaceList& solid) {
    if (std::optional<model::Polyhedron> whole = as_convex(mesh_, solid, neighbours_, regions_, near_)) {
      pieces_.push_back(std::move(*whole));
      return;
    }
    Limits left = limits_;
    left.max_pieces -= std::min(left.max_pieces, pieces_.size());
    Soup soup = make_soup(solid);
    const std::vector<Level> levels = find_levels(soup);
    std::vector<convex::Polytope> polytopes =
        partition(std::move(soup), make_cell(solid), levels, planes_, near_, left);
    convex::merge(polytopes, planes_, limits_.work);
    accumulate(solid, polytopes);
    for (const convex::Polytope& polytope : polytopes) pieces_.push_back(to_polyhedron(polytope, planes_));
  }

  void accumulate(const FaceList& solid, std::span<const convex::Polytope> polytopes) {
    gain_ -= six_times_volume(mesh_, solid) / 6;
    for (const std::uint32_t face : solid) area_ += glm::length(area_vector(mesh_, mesh_.faces[face])) / 2;
    for (const convex::Polytope& polytope : polytopes) gain_ += convex::volume(polytope);
  }

  [[nodiscard]] Soup make_soup(const FaceList& solid) const {
    Soup soup;
    std::map<std::uint32_t, std::uint32_t> places;
    for (const std::uint32_t face : solid) {
      if (regions_.of_face[face] == none) continue;
      const auto begin = static_cast<std::uint32_t>(soup.corners.size());
      const std::vector<std::uint32_t>& corners = mesh_.faces[face];
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        const auto [place, is_new] = places.try_emplace(corners[k], static_cast<std::uint32_t>(soup.points.size()));
        if (is_new) soup.points.push_back(mesh_.points[corners[k]] - planes_.centre());
        soup.corners.push_back({place->second, is_reflex(face, k)});
      }
      soup.fragments.push_back(
          {halfspaces_[regions_.of_face[face]], begin, static_cast<std::uint32_t>(soup.corners.size())});
    }
    return soup;
  }

  /// Whether the face beyond a side rises in front of this face; true if the side has no unique neighbour.
  [[nodiscard]] bool is_reflex(std::uint32_t face, std::uint32_t side) const {
    const std::uint32_t beyond = neighbours_.face[neighbours_.first_side[face] + side];
    if (beyond == none) return true;
    const std::uint32_t region = regions_.of_face[face];
    if (regions_.of_face[beyond] == region || regions_.of_face[beyond] == none) return false;
    const facet::Plane& plane = regions_.planes[region];
    return std::ranges::any_of(mesh_.faces[beyond],
                               [&](std::uint32_t corner) { return plane.height(mesh_.points[corner]) > near_; });
  }

  /// Levels of the soup, sorted by axis and place.
  std::vector<Level> find_levels(const Soup& soup) {
    std::vector<Level> levels;
    for (int axis = 0; axis < 3; ++axis) {
      const std::vector<double> places = edges_across(soup, axis);
      glm::dvec3 normal(0);
      normal[axis] = 1;
      for (auto begin = places.begin(); begin != places.end();) {
        const auto end = std::find_if(begin, places.end(), [&](double place) { return place > *begin + near_; });
        if (end - begin >= min_sides_in_level) {
          levels.push_back({axis, *begin, planes_.add({normal, -(*begin + planes_.centre()[axis])})});
        }
        begin = end;
      }
    }
    return levels;
  }

  /// Sorted positions along an axis of the reflex edges that are perpendicular to it.
  [[nodiscard]] std::vector<double> edges_across(const Soup& soup, int axis) const {
    std::vector<double> places;
    for (const Fragment& fragment : soup.fragments) {
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
        if (!soup.corners[i].reflex) continue;
        const std::uint32_t next = i + 1 < fragment.end ? i + 1 : fragment.begin;
        const double place = soup.points[soup.corners[i].point][axis];
        if (std::abs(soup.points[soup.corners[next].point][axis] - place) <= near_) places.push_back(place);
      }
    }
    std::sort(places.begin(), places.end());
    return places;
  }

  /// A box around the solid, with a margin of a tenth of the model's diagonal.
  convex::Polytope make_cell(const FaceList& solid) {
    facet::Box box = box_of(mesh_, solid);
    const double margin = 0.1 * planes_.diagonal();
    box = {box.low - margin, box.high + margin};
    return convex::intersection({box.low - planes_.centre(), box.high - planes_.centre()},
                                convex::add_box_halfspaces(box, planes_), planes_);
  }

  Mesh mesh_;
  const Limits& limits_;
  Neighbours neighbours_;
  Regions regions_;
  facet::PlaneTable planes_;
  double near_;
  std::vector<facet::Halfspace> halfspaces_;  ///< half-space of each region
  std::vector<model::Polyhedron> pieces_;
  double gain_ = 0;  ///< volume of the pieces minus that of the solids
  double area_ = 0;  ///< surface area of the solids
};

/// Divides the solid with each face in its own plane, so that losses and gains by tolerances appear in the volume.
std::vector<model::Polyhedron> exact_pieces(const Mesh& mesh, const facet::Box& box, Limits limits) {
  limits.tolerance = double_precision_tolerance;
  limits.checks_coverage = false;
  Division division(mesh, box, limits);
  std::vector<model::Polyhedron> pieces = division();
  if (!division.keeps_volume())
    throw WindingError(
        "the faces of the solid cross each other along edges; write it as a union of solids whose faces do not");
  return pieces;
}

}  // namespace

std::vector<model::Polyhedron> convex_pieces(const Mesh& mesh, const Limits& limits) {
  if (mesh.faces.empty()) return {};
  const facet::Box box = facet::box_of(mesh.points);
  try {
    Division division(mesh, box, limits);
    std::vector<model::Polyhedron> pieces = division();
    if (division.keeps_volume()) return pieces;
  } catch (const HoleError&) {
    // a division with each face in its own plane may leave no hole
  }
  return exact_pieces(mesh, box, limits);
}

std::vector<model::Polyhedron> enclosed_pieces(const Mesh& mesh, const Limits& limits) {
  if (mesh.faces.empty()) return {};
  return Division(mesh, facet::box_of(mesh.points), limits).enclosed_pieces();
}

}  // namespace csgsim::solids
