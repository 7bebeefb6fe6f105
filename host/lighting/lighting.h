// Lights, finishes and the colours of illuminated surfaces.
// Used by host/effects, host/emit and sim/studies.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"
#include "host/scene/scene.h"
#include "host/view/camera.h"

namespace csgsim::lighting {

/// Default colours of solids, cut faces and the background, red, green, blue in [0, 1].
inline constexpr glm::dvec3 default_colour{0.976, 0.843, 0.173};
inline constexpr glm::dvec3 default_cut_colour{0.616, 0.796, 0.318};
inline constexpr glm::dvec3 background_colour{1.0, 1.0, 0.898};

/// A light in camera space: the axes are right, up and forward, and the origin is the eye.
struct CameraSpaceLight {
  bool is_point = false;
  glm::dvec3 where{0};   ///< point light: position in model units; directional light: unit vector towards the light
  glm::dvec3 colour{0};  ///< colour times intensity
};

/// All lights of a scene as one camera sees them.
struct Lighting {
  glm::dvec3 ambient{0};
  std::vector<CameraSpaceLight> lights;
  bool is_perspective = false;

  /// Whether the light on the material depends on more than the normal, so that lit_colour() reads `place`.
  [[nodiscard]] bool is_local(const scene::Material& material) const;
};

/// The scene's lights. A scene without lights gets one light, fixed to the camera, from the upper left behind the eye.
Lighting make_lighting(const scene::Scene& scene, const view::Camera& camera);

/// A point of a surface, in camera space.
struct SurfacePoint {
  glm::dvec3 place;   ///< model units
  glm::dvec3 normal;  ///< unit vector, on the side of the viewer
};

/// The visible colour: ambient light, Lambert's law and Blinn's highlight. Components may exceed 1.
glm::dvec3 lit_colour(const Lighting& lighting, const scene::Material& material, const glm::dvec3& colour,
                      const SurfacePoint& point);

/// Whether the selection contains the primitive.
bool is_selected(const scene::PrimitiveSelection& selection, const model::Primitive& primitive);

/// The appearance of a primitive: from the scene if it has settings, otherwise from the model if it has any, otherwise
/// the defaults.
struct Finish {
  glm::dvec3 colour;
  scene::Material material;
  double opacity = 1;  ///< from 0, transparent, to 1, opaque
};

/// The finish of a primitive. `is_cut`: whether this is the surface of a subtracted solid.
Finish make_finish(const scene::Scene& scene, const model::Primitive& primitive, bool is_cut);

}  // namespace csgsim::lighting
