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
  glm::dvec3 place{0};      ///< position of a point light
  glm::dvec3 direction{0};  ///< unit vector towards a directional light
  glm::dvec3 colour{0};     ///< colour multiplied by the intensity
};

/// A surface's colour and reflection coefficients.
struct RayFinish {
  glm::dvec3 colour;
  scene::Material material;
};

/// The lights of a scene and the colours of its facets. Each facet is shaded as a whole with one normal and, for nearby
/// lights, one position: the mean of the primitive's vertices on the facet's plane.
class RayLighting {
 public:
  /// Lights given in camera axes stay in place for any eye, including mirrored ones. Keeps a reference to the model.
  RayLighting(const model::Tree& tree, const facet::Geometry& facets, const RayModel& model, const scene::Scene& scene,
              const view::EyeSpace& camera);

  [[nodiscard]] const std::vector<RayLight>& lights() const { return lights_; }

  /// The cosine between a facet's normal and the direction to a light.
  [[nodiscard]] double cosine_to_light(const SurfacePoint& facet, const RayLight& light) const;

  /// Whether a light at grazing incidence is still visible on the primitive's facets.
  [[nodiscard]] bool has_highlights(std::uint32_t primitive) const {
    return finishes_[primitive].material.specular > 0.0;
  }

  /// Red, green and blue in [0, 1], not rounded. `counts` states for each light whether it is unshadowed; a light
  /// behind the facet contributes nothing. `eye` may be a mirrored eye.
  [[nodiscard]] glm::dvec3 colour(const SurfacePoint& facet, const std::vector<bool>& counts,
                                  const view::EyeSpace& eye) const;

 private:
  [[nodiscard]] const glm::dvec3& middle(const SurfacePoint& facet) const {
    return middles_[facet.primitive][facet.halfspace];
  }
  [[nodiscard]] glm::dvec3 direction_to(const SurfacePoint& facet, const RayLight& light) const;

  const RayModel& model_;
  glm::dvec3 ambient_;
  std::vector<RayLight> lights_;
  std::vector<RayFinish> finishes_;               ///< colour and reflection of each primitive
  std::vector<std::vector<glm::dvec3>> middles_;  ///< middles of the facets, by primitive and half-space
};

}  // namespace csgsim::testing
