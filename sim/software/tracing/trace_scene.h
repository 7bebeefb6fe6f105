// Facets and rays of a picture to be traced.
// Used by trace.h, primary_rays.h and secondary_rays.h.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/facets/facets.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/space/directory.h"
#include "sim/software/space/facet_shapes.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// A model's facets, in space and in a picture, and the rays of its pixels.
///
/// Events at a pixel are those of ScreenFacets, in integers. A facet is *loose* if these events do not match its
/// position in space: they are farther away than half the reach of directories, before the near plane, or the facet has
/// no corners. Loose facets are in no cell; every ray of a pixel in their rectangle is tested against them. The events
/// of all other facets are in cells that contain the facet.
class TraceScene {
 public:
  /// Keeps references. Throws InputError as facets_of() and screen_facets() do.
  TraceScene(const model::Tree& model, const facet::Geometry& geometry, const view::View& view, const Tree& tree);

  TraceScene(const TraceScene&) = delete;
  TraceScene& operator=(const TraceScene&) = delete;

  static constexpr std::uint32_t none = 0xffffffffU;

  [[nodiscard]] const facet::Geometry& geometry() const { return geometry_; }
  [[nodiscard]] const view::View& view() const { return view_; }
  [[nodiscard]] const Tree& tree() const { return tree_; }
  [[nodiscard]] const Facets& facets() const { return facets_; }
  [[nodiscard]] const FacetShapes& shapes() const { return shapes_; }
  [[nodiscard]] const ScreenFacets& screen() const { return screen_; }
  [[nodiscard]] std::uint32_t width() const { return view_.sampling.width; }
  [[nodiscard]] std::uint32_t height() const { return view_.sampling.height; }

  /// Index of the facet in the picture; none if it is not visible or is loose.
  [[nodiscard]] std::uint32_t screen_of(std::uint32_t facet) const { return screen_of_[facet]; }
  /// The loose facets of a row, as indices into ScreenFacets::facets.
  [[nodiscard]] std::span<const std::uint32_t> loose_in(std::uint32_t row) const { return loose_[row]; }
  [[nodiscard]] std::uint64_t loose() const { return loose_facets_; }

  /// The ray of a pixel; t is the distance along the view axis in model units.
  [[nodiscard]] SpaceRay ray_of(std::int32_t column, std::int32_t row) const;
  /// The depth up to which all events are known if the ray is settled up to t, allowing for rounding.
  [[nodiscard]] double depth_at(double t) const;
  /// Upper bound of the displacement by rounding of a point along a ray, model units.
  [[nodiscard]] double slack() const { return slack_; }
  /// Converts a direction from camera axes (right, up, forward) to model space.
  [[nodiscard]] glm::dvec3 direction_of(const glm::dvec3& in_camera) const;
  /// Converts a point from camera axes to model space, relative to PlaneTable::centre().
  [[nodiscard]] glm::dvec3 place_of(const glm::dvec3& in_camera) const;

 private:
  [[nodiscard]] bool is_loose(const ScreenFacet& facet) const;
  /// Whether the integer depth at a pixel is too far from the polygon with these corners.
  [[nodiscard]] bool is_far(const ScreenFacet& facet, std::span<const glm::dvec3> corners, std::int32_t column,
                            std::int32_t row) const;

  const facet::Geometry& geometry_;
  const view::View& view_;
  const Tree& tree_;
  Facets facets_;
  FacetShapes shapes_;
  ScreenFacets screen_;
  view::EyeSpace eye_;
  double slack_ = 0;
  double begin_ = 0;
  double end_ = 0;
  std::vector<std::uint32_t> screen_of_;
  std::vector<std::vector<std::uint32_t>> loose_;  ///< indexed by row
  std::uint64_t loose_facets_ = 0;
};

}  // namespace csgsim::software
