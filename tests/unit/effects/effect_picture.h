#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "tests/support/drawing.h"

namespace csgsim::testing {

/// A scene file with more keys, read as the command line reads it.
scene::Scene scene_of(const std::string& toml, const std::vector<std::string>& sets = {});

/// Boxes seen along +y, orthographically: the pixel in column x and row y is that through the model's (x + 0.5, any,
/// -y - 0.5). All effects there are, those called for that the scene or the model calls for.
Setup front_view(std::uint32_t width, std::uint32_t height, scene::Scene scene);

/// Ambient light alone: every surface has its own colour. Black behind all.
inline const std::string plain_colours =
    "[background]\ncolour = [0, 0, 0]\n[ambient]\nintensity = 1\n[[lights]]\n"
    "direction = [0, 1, 0]\nintensity = 0\n";

/// A box from one corner to the other, as OpenSCAD prints it.
std::string box_text(const glm::dvec3& low, const glm::dvec3& high);

/// In a colour with an alpha.
std::string tinted(const glm::dvec3& colour, double alpha, const std::string& csg);

}  // namespace csgsim::testing
