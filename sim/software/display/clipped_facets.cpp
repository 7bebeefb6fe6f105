#include "sim/software/display/clipped_facets.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <span>
#include <utility>

#include "host/convex/clip.h"
#include "sim/software/display/count_clipping.h"
#include "sim/software/display/facet_sheets.h"
#include "sim/software/methods/counts.h"
#include "sim/software/space/facet_shapes.h"

namespace csgsim::software {

namespace {

/// A part of a facet that remains after clipping.
struct Part {
  Region region;
  std::vector<Cut> cuts;
  UnitBox box;
};

template <class Count>
class FacetClipper {
 public:
  FacetClipper(const Facets& facets, const facet::Geometry& geometry, Count& count)
      : facets_(facets),
        reach_(convex::tolerance(geometry.planes)),
        thinnest_(thinnest * geometry.planes.diagonal()),
        sheets_(facets, geometry),
        parts_(facets.facets.size()),
        count_(count) {
    for (std::uint32_t facet = 0; facet < parts_.size(); ++facet) {
      Region whole = sheets_.whole(facet);
      if (!whole.empty()) parts_[facet].push_back(part(facet, std::move(whole), {}));
    }
  }

  ClippedFacets clipped(const DirectoryRow& row, std::uint32_t bucket_size) {
    const FacetShapes shapes(facets_, reach_);
    const std::unique_ptr<Directory> directory = row.make(shapes, {bucket_size});
    clip_in_cells(directory->parts());
    const SpaceBuilt built = directory->built();
    add_build_counts(count_, built.operations);
    made_.overlap_tests = built.overlap_tests;
    for (std::uint32_t facet = 0; facet < parts_.size(); ++facet) add(facet);
    made_.polygons.of_primitives.push_back(made_.polygons.facets.size());
    return std::move(made_);
  }

 private:
  /// Relative to the model's diagonal.
  static constexpr double thinnest = 1e-8;

  [[nodiscard]] Part part(std::uint32_t facet, Region region, std::vector<Cut> cuts) const {
    const UnitBox box = sheets_.sheet_of(facet).bounds(region).box;
    return {std::move(region), std::move(cuts), box};
  }

  /// Clips each pair once, even if it shares several cells.
  void clip_in_cells(const std::vector<SpacePart>& space) {
    std::vector<std::vector<std::uint32_t>> cells_of(parts_.size());
    for (std::uint32_t cell = 0; cell < space.size(); ++cell) {
      for (const std::uint32_t facet : space[cell].facets) cells_of[facet].push_back(cell);
    }
    std::vector<std::uint32_t> held_against(parts_.size(), SpacePart::none);
    for (std::uint32_t facet = 0; facet < parts_.size(); ++facet) {
      for (const std::uint32_t cell : cells_of[facet]) {
        for (const std::uint32_t other : space[cell].facets) {
          count_(Operation::load, 2);
          count_(Operation::compare, 2);
          count_(Operation::branch, 2);
          if (other >= facet || held_against[other] == facet) continue;
          held_against[other] = facet;
          if (facets_.facets[other].primitive != facets_.facets[facet].primitive) clip(facet, other);
        }
      }
    }
  }

  void clip(std::uint32_t one, std::uint32_t other) {
    std::vector<Part>& of_one = parts_[one];
    std::vector<Part>& of_other = parts_[other];
    for (std::size_t i = 0; i < of_one.size(); ++i) {
      for (std::size_t j = 0; j < of_other.size(); ++j) {
        if (!cross(one, of_one[i], other, of_other[j])) continue;
        cut(one, i, sheets_.plane_of(other));
        cut(other, j, sheets_.plane_of(one));
      }
    }
  }

  bool cross(std::uint32_t one, const Part& of_one, std::uint32_t other, const Part& of_other) {
    ++made_.crossing_tests;
    count_(Operation::load_long, 12);
    count_(Operation::compare_long, 6);
    count_(Operation::branch, 6);
    if (are_apart(of_one.box, of_other.box)) return false;
    constexpr std::size_t ends = 2;
    count_heights(count_, of_one.region.corners.size() + of_other.region.corners.size());
    if (!sheets_.cross(one, of_one.region, other, of_other.region)) return false;
    count_crossings(count_, 2 * ends);
    count_heights(count_, 2 * ends);
    count_(Operation::compare_long, 2);
    count_(Operation::branch, 2);
    return true;
  }

  /// Keeps the part on the plane's positive side, and appends the other part to the facet's parts.
  void cut(std::uint32_t facet, std::size_t number, std::uint32_t plane) {
    Part& whole = parts_[facet][number];
    Parts halves = sheets_.sheet_of(facet).cut(whole.region, {plane, true});
    constexpr std::size_t ends = 2;
    count_crossings(count_, ends);
    count_(Operation::store_long, 6 + 3 * (halves.in.corners.size() + halves.out.corners.size()));
    std::vector<Cut> cuts = whole.cuts;
    cuts.push_back({plane, false});
    Part out = part(facet, std::move(halves.out), std::move(cuts));
    whole.cuts.push_back({plane, true});
    whole = part(facet, std::move(halves.in), std::move(whole.cuts));
    parts_[facet].push_back(std::move(out));
  }

  void add(std::uint32_t facet) {
    while (made_.polygons.of_primitives.size() <= facets_.facets[facet].primitive)
      made_.polygons.of_primitives.push_back(made_.polygons.facets.size());
    if (parts_[facet].empty()) add(facet, place_of(facet), {});
    for (Part& part : parts_[facet])
      add(facet, entered(sheets_.corner_positions(facet, part.region)), std::move(part.cuts));
  }

  void add(std::uint32_t facet, std::span<const glm::dvec3> corners, std::vector<Cut> cuts) {
    Facets& polygons = made_.polygons;
    const std::size_t begin = polygons.corners.size();
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.facets.push_back(
        {facets_.facets[facet].primitive, facets_.facets[facet].halfspace, begin, polygons.corners.size()});
    made_.facets.push_back(facet);
    made_.cuts.push_back(std::move(cuts));
  }

  /// Corners that stand for a facet without area.
  [[nodiscard]] std::vector<glm::dvec3> place_of(std::uint32_t facet) const {
    const std::span<const glm::dvec3> own = facets_.corners_of(facet);
    if (!own.empty()) return entered({own.begin(), own.end()});
    const std::uint32_t primitive = facets_.facets[facet].primitive;
    for (std::size_t i = facets_.of_primitives[primitive]; i < facets_.of_primitives[primitive + 1]; ++i) {
      const std::span<const glm::dvec3> others = facets_.corners_of(static_cast<std::uint32_t>(i));
      if (!others.empty()) return {others.front()};
    }
    return {glm::dvec3{0}};
  }

  /// Corners in the form in which they are inserted into directories.
  [[nodiscard]] std::vector<glm::dvec3> entered(std::vector<glm::dvec3> corners) const {
    glm::dvec3 area{0};
    for (std::size_t i = 2; i < corners.size(); ++i)
      area += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    if (glm::length(area) > thinnest_ * facet::box_of(corners).diagonal()) return corners;
    std::vector<glm::dvec3> farthest{corners.front(), corners.front()};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (glm::distance(corners[i], corners[j]) > glm::distance(farthest[0], farthest[1]))
          farthest = {corners[j], corners[i]};
      }
    }
    return farthest;
  }

  const Facets& facets_;
  double reach_;
  double thinnest_;
  FacetSheets sheets_;
  std::vector<std::vector<Part>> parts_;  ///< indexed by facet
  Count& count_;
  ClippedFacets made_;
};

}  // namespace

template <class Count>
ClippedFacets clip_facets_against_each_other(const Facets& facets, const facet::Geometry& geometry,
                                             const DirectoryRow& directory, std::uint32_t bucket_size, Count& count) {
  return FacetClipper<Count>(facets, geometry, count).clipped(directory, bucket_size);
}

template ClippedFacets clip_facets_against_each_other(const Facets&, const facet::Geometry&, const DirectoryRow&,
                                                      std::uint32_t, CountingMethod&);
template ClippedFacets clip_facets_against_each_other(const Facets&, const facet::Geometry&, const DirectoryRow&,
                                                      std::uint32_t, UncountedMethod&);

}  // namespace csgsim::software
