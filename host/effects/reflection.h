// Reflections of models and lights in a plane.
// Used by mirrors.cpp.
#pragma once

#include <memory>
#include <vector>

#include "host/facet/geometry.h"
#include "host/lighting/lighting.h"
#include "host/model/tree.h"
#include "host/view/camera.h"

namespace csgsim::effects {

/// A reflected model.
struct Reflected {
  std::shared_ptr<const model::Tree> tree;
  std::shared_ptr<const facet::Geometry> geometry;  ///< half-spaces, vertices and edges are in the same order
  std::vector<facet::Halfspace> of_planes;          ///< by canonical plane: its positive half-space
};

/// Reflects the model; `plane` is an index into the scene's canonical planes.
Reflected reflected(const model::Tree& tree, const facet::Geometry& geometry, std::uint32_t plane);

/// Reflected lighting, in the same camera space as its source.
lighting::Lighting reflected(const lighting::Lighting& lighting, const facet::Geometry& geometry, std::uint32_t plane,
                             const view::Camera& camera);

}  // namespace csgsim::effects
