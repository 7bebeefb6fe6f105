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
  /// Half-spaces, vertices and edges are in the same order as in the model.
  std::shared_ptr<const facet::Geometry> geometry;
  /// Per canonical plane of the model: the reflection of its positive half-space.
  std::vector<facet::Halfspace> of_planes;
};

/// Reflects the model in the canonical plane with the index `plane`.
Reflected reflected(const model::Tree& tree, const facet::Geometry& geometry, std::uint32_t plane);

/// Reflects the lighting; the result is in the same camera space as its source.
lighting::Lighting reflected(const lighting::Lighting& lighting, const facet::Geometry& geometry, std::uint32_t plane,
                             const view::Camera& camera);

}  // namespace csgsim::effects
