#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// Parses a scene file with additional keys, as the command line does.
scene::Scene scene_of(const std::string& toml, const std::vector<std::string>& sets = {});

/// Orthographic view along +y: the pixel in column x and row y is the line through (x + 0.5, any, -y - 0.5) of the
/// model. All effects are available; those that the scene or the model requests are active.
Setup front_view(std::uint32_t width, std::uint32_t height, scene::Scene scene);

/// Ambient light only, so every surface shows its exact colour; black background.
inline const std::string plain_colours =
    "[background]\ncolour = [0, 0, 0]\n[ambient]\nintensity = 1\n[[lights]]\n"
    "direction = [0, 1, 0]\nintensity = 0\n";

/// A box between two corners, as printed by OpenSCAD.
std::string box_text(const glm::dvec3& low, const glm::dvec3& high);

/// Wraps the text in a colour with alpha.
std::string tinted(const glm::dvec3& colour, double alpha, const std::string& csg);

}  // namespace csgsim::testing
