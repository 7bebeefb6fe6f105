// The appearance of a model: lighting and finishes.
// Used by host/setup and sim/studies.
#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/lighting/lighting.h"
#include "host/scene/scene.h"

namespace csgsim::emit {

/// The appearance of a model to a camera; it does not depend on the strategy.
struct Look {
  lighting::Lighting lighting;
  std::vector<lighting::Finish> finishes;  ///< one per primitive
};

/// A colour, red, green, blue in [0, 1], in the format of a field of `colour_bits` bits.
std::uint32_t packed_colour(const glm::dvec3& colour, unsigned colour_bits);

/// The background colour in the format of a field of `colour_bits` bits.
std::uint32_t packed_background(const scene::Scene& scene, unsigned colour_bits);

Look make_look(const scene::Scene& scene, const model::Tree& tree, const csg::PositiveTree& positive,
               const view::Camera& camera);

}  // namespace csgsim::emit
