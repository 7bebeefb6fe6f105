#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/model/tree.h"
#include "host/scene/scene.h"
#include "host/view/camera.h"

namespace csgsim::lighting {

/// Colours of things whose model says none, and of the background, red, green, blue in [0, 1].
inline constexpr glm::dvec3 default_colour{0.976, 0.843, 0.173};
inline constexpr glm::dvec3 default_cut_colour{0.616, 0.796, 0.318};
inline constexpr glm::dvec3 background_colour{1.0, 1.0, 0.898};

/// A light as the camera has it: axes right, up, forward, the eye at 0.
struct SeenLight {
  bool is_point = false;
  glm::dvec3 where{0};   ///< point: its place, model units; directional: the direction to it, of length 1
  glm::dvec3 colour{0};  ///< times its intensity
};

/// All light of a scene as one camera sees it.
struct Lighting {
  glm::dvec3 ambient{0};
  std::vector<SeenLight> lights;
  bool is_perspective = false;

  /// Whether light depends on more than the normal: whether lit() reads `place`.
  [[nodiscard]] bool is_local(const scene::Material& material) const;
};

/// The scene's lights; if it has none, one that is fixed to the camera, from the upper left behind the eye.
Lighting lighting_of(const scene::Scene& scene, const view::Camera& camera);

/// A place of a surface, in the camera's axes.
struct SurfacePoint {
  glm::dvec3 place;   ///< model units
  glm::dvec3 normal;  ///< of length 1, to the viewer's side
};

/// What is seen of a colour: ambient light, Lambert's law, and Blinn's highlight. Components may be above 1.
glm::dvec3 lit(const Lighting& lighting, const scene::Material& material, const glm::dvec3& colour,
               const SurfacePoint& at);

/// Whether the scene's finish for these primitives holds for that one.
bool is_chosen(const scene::Chosen& chosen, const model::Primitive& primitive);

/// How a primitive looks: what the scene says of it, else the model, else the usual.
struct Finish {
  glm::dvec3 colour;
  scene::Material material;
  double opacity = 1;  ///< from 0, clear, to 1
};

/// `is_cut`: it is the surface of what was taken away.
Finish finish_of(const scene::Scene& scene, const model::Primitive& primitive, bool is_cut);

}  // namespace csgsim::lighting
