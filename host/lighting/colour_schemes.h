// OpenSCAD's colour schemes.
// Used by sim/session.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "host/scene/scene.h"

namespace csgsim::lighting {

/// A named set of colours (red, green, blue in [0, 1]) that OpenSCAD's preview uses for the background and for solids
/// without a colour.
struct ColourScheme {
  std::string_view name;
  glm::dvec3 background;
  glm::dvec3 face;
  glm::dvec3 cut_face;  ///< colour where a solid was subtracted
};

/// The schemes of OpenSCAD 2021.01, from its folder color-schemes/render: background, opencsg-face-front,
/// opencsg-face-back. The first is the default, as in OpenSCAD.
std::span<const ColourScheme> colour_schemes();

/// Replaces the background and the default colours of the scene by those of the scheme.
void apply(const ColourScheme& scheme, scene::Scene& scene);

}  // namespace csgsim::lighting
