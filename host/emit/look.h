#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/lighting/lighting.h"
#include "host/scene/scene.h"

namespace csgsim::emit {

/// How a model looks to a camera, whatever the strategy.
struct Look {
  lighting::Lighting lighting;
  std::vector<lighting::Finish> finishes;  ///< one a primitive
};

/// A colour, red, green, blue in [0, 1], as a field of `colour_bits` bits holds it.
std::uint32_t packed(const glm::dvec3& colour, unsigned colour_bits);

/// Where nothing is seen, as a field of so many bits holds it.
std::uint32_t packed_background(const scene::Scene& scene, unsigned colour_bits);

Look make_look(const scene::Scene& scene, const model::Tree& tree, const csg::PositiveTree& positive,
               const view::Camera& camera);

}  // namespace csgsim::emit
