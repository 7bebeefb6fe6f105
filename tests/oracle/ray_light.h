#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/scene/scene.h"
#include "host/view/eye_space.h"
#include "tests/oracle/ray_model.h"

namespace csgsim::testing {

/// A light in model space.
struct RayLight {
  bool is_point = false;
  glm::dvec3 place{0};      ///< of a point light
  glm::dvec3 direction{0};  ///< of length 1, to a directional light
  glm::dvec3 colour{0};     ///< times its intensity
};

/// A surface's colour and how it throws light back.
struct RayFinish {
  glm::dvec3 colour;
  scene::Material material;
};

/// The lights of a scene and the colours of its facets, each shaded as a whole: one normal and, for what is near, one
/// place, the mean of the primitive's vertices that are on the facet's plane.
class RayLighting {
 public:
  /// Lights given in the camera's axes are where they are whatever eye looks. Keeps a reference to the model.
  RayLighting(const model::Tree& tree, const facet::Geometry& facets, const RayModel& model, const scene::Scene& scene,
              const view::EyeSpace& camera);

  [[nodiscard]] const std::vector<RayLight>& lights() const { return lights_; }

  /// The cosine between a facet's normal and the way to a light.
  [[nodiscard]] double facing(const SurfacePoint& facet, const RayLight& light) const;

  /// Whether a light that barely reaches a primitive's facets is seen on them all the same.
  [[nodiscard]] bool has_highlights(std::uint32_t primitive) const {
    return finishes_[primitive].material.specular > 0.0;
  }

  /// Red, green and blue in [0, 1], not rounded. `counts` says of each light whether it is not in shadow; one that the
  /// facet turns away from adds nothing. `eye` may be a mirrored one.
  [[nodiscard]] glm::dvec3 colour(const SurfacePoint& facet, const std::vector<bool>& counts,
                                  const view::EyeSpace& eye) const;

 private:
  [[nodiscard]] const glm::dvec3& middle(const SurfacePoint& facet) const {
    return middles_[facet.primitive][facet.halfspace];
  }
  [[nodiscard]] glm::dvec3 way_to(const SurfacePoint& facet, const RayLight& light) const;

  const RayModel& model_;
  glm::dvec3 ambient_;
  std::vector<RayLight> lights_;
  std::vector<RayFinish> finishes_;               ///< one a primitive
  std::vector<std::vector<glm::dvec3>> middles_;  ///< of the facets, a primitive and half-space
};

}  // namespace csgsim::testing
