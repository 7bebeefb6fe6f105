#pragma once

#include <glm/vec3.hpp>

namespace csgsim::effects {

/// One directional light fixed to the camera, plus ambient light.
struct FlatShading {
  glm::dvec3 to_light{-0.36, 0.56, -0.75};  ///< right, up, forward; need not have length 1
  double ambient = 0.30;
  double diffuse = 0.70;
};

/// Colours of things whose model says none, and of the background, red, green, blue in [0, 1].
inline constexpr glm::dvec3 default_colour{0.976, 0.843, 0.173};
inline constexpr glm::dvec3 default_cut_colour{0.616, 0.796, 0.318};
inline constexpr glm::dvec3 background_colour{1.0, 1.0, 0.898};

/// The colour of a facet whose unit normal, pointing to the viewer's side, is given in right, up, forward.
glm::dvec3 shade(const FlatShading& shading, const glm::dvec3& colour, const glm::dvec3& normal);

}  // namespace csgsim::effects
