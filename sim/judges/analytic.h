#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/program.h"
#include "sim/judges/solid_ray.h"
#include "sim/judges/truth.h"

namespace csgsim::judges {

/// The picture of the model's true spheres, cylinders and cones (and boxes and polyhedra) under their transforms, by
/// the rules of exact_truth: what faceting costs is the difference from it. It has no planes.
///
/// Worked out in long double, about the point of a ray that is nearest to the primitive's origin: depths are right to
/// some 1e-15 of the distance, and to 1e-8 of a curved solid's size where its outline is grazed. Depths closer than
/// 1e-9 of the distance (in an orthographic view of |centre - eye|, if that is more) are taken as equal. Rays are moved
/// right by 1e-9 pixels and down by 1e-10, which decides what is seen edge-on as the tie rule does. `depth` is used for
/// its near plane only.
///
/// `drawn_as` is how the picture that is judged was faceted: what stays the polygon that the model says (meant.h) is
/// that here too.
Truth analytic_truth(const model::Tree& tree, const facet::Faceting& drawn_as, const view::Camera& camera,
                     std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth);

/// The same of one depth scale after the other. Another near plane changes only what is seen of rays that meet a solid
/// before it or the one before: only these are followed again.
class AnalyticPictures {
 public:
  /// The tree outlives this.
  AnalyticPictures(const model::Tree& tree, const facet::Faceting& drawn_as, const view::Camera& camera,
                   std::uint32_t width, std::uint32_t height);

  const Truth& truth(const isa::DepthScale& depth);

 private:
  const model::Tree& tree_;
  view::Camera camera_;
  std::vector<model::Primitive> meant_;
  std::vector<TrueSolid> solids_;
  Truth truth_;                       ///< with the near plane of the last depth scale
  std::optional<long double> near_;   ///< where that is
  std::vector<long double> nearest_;  ///< a pixel: where its ray first meets a solid, before any near plane too
};

}  // namespace csgsim::judges
