// Facets with their bounding boxes and overlap tests.
// Used by all directories.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/software/cost/operations.h"
#include "sim/software/facets/facets.h"

namespace csgsim::software {

/// Default reach of directories around a facet, relative to the model's diagonal: 1/40 pixel if the model fills a
/// picture of 512 pixels. It exceeds the displacement of most facets of a picture by rounding (TraceScene).
inline constexpr double default_reach = 0x1p-14;

/// Facets in the form that directories use: polygons, and edges and corners that remain of half-spaces without area.
class FacetShapes {
 public:
  /// Keeps a reference. A cell contains the facets whose distance along every axis is at most the reach.
  FacetShapes(const Facets& facets, double reach);
  /// Uses the default reach.
  explicit FacetShapes(const Facets& facets);

  [[nodiscard]] const Facets& facets() const { return facets_; }
  [[nodiscard]] double reach() const { return reach_; }
  /// Contains all facets and a margin of twice the reach.
  [[nodiscard]] const facet::Box& box() const { return box_; }
  /// Bounding box of a facet with corners, including the reach.
  [[nodiscard]] const facet::Box& box_of(std::uint32_t facet) const { return boxes_[facet]; }
  /// Facets with corners, in order.
  [[nodiscard]] std::span<const std::uint32_t> placed() const { return placed_; }
  /// Facets without corners, which are in no directory.
  [[nodiscard]] std::span<const std::uint32_t> unplaced() const { return unplaced_; }

  /// Whether a facet with corners is within reach of a closed box: no separating axis exists between the box, grown by
  /// the reach, and its corners (axes of the box, the facet's normal, and cross products of box axes and edges).
  /// Rounding and very short edges can only add false positives.
  bool touches(std::uint32_t facet, const facet::Box& box, Counting& count) const;

 private:
  Facets const& facets_;
  double reach_ = 0;
  facet::Box box_;
  std::vector<facet::Box> boxes_;
  std::vector<glm::dvec3> normals_;  ///< outward unit normals; 0 for facets without area
  std::vector<std::uint32_t> placed_;
  std::vector<std::uint32_t> unplaced_;
};

}  // namespace csgsim::software
