#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/software/cost/operations.h"
#include "sim/software/facets/facets.h"

namespace csgsim::software {

/// What directories reach beyond a facet if nobody says, of the model's diagonal: a fortieth of a pixel where the model
/// fills a picture of 512 pixels. More than rounding moves most facets of a picture (TraceScene).
inline constexpr double usual_reach = 0x1p-14;

/// Facets as directories take them, in space: polygons, and the edges and corners that are left of half-spaces without
/// an area.
class FacetShapes {
 public:
  /// Keeps a reference. A cell has the facets that are no farther from it than the reach along any axis.
  FacetShapes(const Facets& facets, double reach);
  /// With the usual reach.
  explicit FacetShapes(const Facets& facets);

  [[nodiscard]] const Facets& facets() const { return facets_; }
  [[nodiscard]] double reach() const { return reach_; }
  /// Holds all facets, and twice the reach around them.
  [[nodiscard]] const facet::Box& box() const { return box_; }
  /// Of a facet with corners, and the reach around it.
  [[nodiscard]] const facet::Box& box_of(std::uint32_t facet) const { return boxes_[facet]; }
  /// Those with corners, in order.
  [[nodiscard]] std::span<const std::uint32_t> placed() const { return placed_; }
  /// Those without, which no directory has a place for.
  [[nodiscard]] std::span<const std::uint32_t> unplaced() const { return unplaced_; }

  /// Whether a facet with corners is within reach of a closed box: no axis separates the box, grown by the reach, from
  /// its corners (of the box's axes, the facet's normal, and those across an axis of the box and an edge). Rounding,
  /// and edges too short to tell a direction, only make it true more often.
  bool touches(std::uint32_t facet, const facet::Box& box, Counting& count) const;

 private:
  Facets const& facets_;
  double reach_ = 0;
  facet::Box box_;
  std::vector<facet::Box> boxes_;
  std::vector<glm::dvec3> normals_;  ///< outward, of length 1; 0 for what has no area
  std::vector<std::uint32_t> placed_;
  std::vector<std::uint32_t> unplaced_;
};

}  // namespace csgsim::software
