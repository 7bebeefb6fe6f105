#pragma once

#include <memory>
#include <vector>

#include "host/facet/geometry.h"
#include "host/lighting/lighting.h"
#include "host/model/tree.h"
#include "host/view/camera.h"

namespace csgsim::effects {

/// A model as it is behind a mirror.
struct Reflected {
  std::shared_ptr<const model::Tree> tree;
  std::shared_ptr<const facet::Geometry> geometry;  ///< half-spaces, vertices and edges in the same order
  std::vector<facet::Halfspace> of_planes;          ///< for each canonical plane the positive half-space of it
};

/// `plane`: of the scene's canonical ones.
Reflected reflected(const model::Tree& tree, const facet::Geometry& geometry, std::uint32_t plane);

/// In the camera's axes as what it is of.
lighting::Lighting reflected(const lighting::Lighting& lighting, const facet::Geometry& geometry, std::uint32_t plane,
                             const view::Camera& camera);

}  // namespace csgsim::effects
