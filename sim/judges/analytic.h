// The picture of a model's true, unfaceted solids.
// Used by sim/studies/accuracy.
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
/// the rules of exact_truth. A faceted picture's difference from it is the error of faceting. Its Truth::plane is
/// empty.
///
/// Computed in long double, relative to the point of a ray nearest to the primitive's origin: depths are accurate to
/// about 1e-15 of the distance, and to 1e-8 of a curved solid's size at grazing rays. Depths closer than 1e-9 of the
/// distance (in an orthographic view of |centre - eye|, if that is greater) are considered equal. Rays are moved right
/// by 1e-9 pixels and down by 1e-10, which resolves edge-on views like the tie rule. Only the near plane of `depth` is
/// used.
///
/// `drawn_as` is the faceting of the picture to be judged: primitives that the model defines as polygons (meant.h) are
/// polygons here too.
Truth analytic_truth(const model::Tree& tree, const facet::Faceting& drawn_as, const view::Camera& camera,
                     std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth);

/// analytic_truth() for a sequence of depth scales. Another near plane only changes rays that meet a solid in front of
/// it or of the previous one: only these are traced again.
class AnalyticPictures {
 public:
  /// The tree must outlive this object.
  AnalyticPictures(const model::Tree& tree, const facet::Faceting& drawn_as, const view::Camera& camera,
                   std::uint32_t width, std::uint32_t height);

  const Truth& truth(const isa::DepthScale& depth);

 private:
  const model::Tree& tree_;
  view::Camera camera_;
  std::vector<model::Primitive> meant_;
  std::vector<TrueSolid> solids_;
  Truth truth_;                      ///< with the near plane of the last depth scale
  std::optional<long double> near_;  ///< the near plane of `truth_`
  std::vector<long double>
      nearest_;  ///< by pixel: distance at which its ray first meets a solid, without the near plane
};

}  // namespace csgsim::judges
