#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "host/scene/scene.h"

namespace csgsim::lighting {

/// Colours under a name, red, green, blue in [0, 1]: those that OpenSCAD's preview gives the background and solids
/// without a colour of their own.
struct ColourScheme {
  std::string_view name;
  glm::dvec3 background;
  glm::dvec3 face;
  glm::dvec3 cut_face;  ///< where a solid was taken away
};

/// The schemes of OpenSCAD 2021.01, from its folder color-schemes/render: background, opencsg-face-front,
/// opencsg-face-back. The first is the default, there and here.
std::span<const ColourScheme> colour_schemes();

/// Puts its colours in the place of the scene's background and of the usual ones.
void apply(const ColourScheme& scheme, scene::Scene& scene);

}  // namespace csgsim::lighting
