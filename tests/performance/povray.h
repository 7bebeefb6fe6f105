#pragma once

#include <string>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/camera.h"

namespace csgsim::bench {

/// The model as a POV-Ray scene: the same half-spaces, intersected to primitives within their boxes, and the same tree,
/// seen by the same orthographic camera, with a shadowless light.
std::string povray_scene(const model::Tree& tree, const facet::Geometry& scene, const view::Camera& camera);

}  // namespace csgsim::bench
