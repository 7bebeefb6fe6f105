#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// A vector in the camera's axes: right, up, forward.
glm::dvec3 in_camera_axes(const view::Camera& camera, const glm::dvec3& v);

/// Out of the solid that is seen, model space, of length 1. Not of a cap, which has no half-space.
glm::dvec3 outward(const Context& context, const Facet& facet);

/// The same in the primitive's own axes, of length 1.
glm::dvec3 own_normal(const Context& context, const Facet& facet);

/// Whether a facet with that normal, model space, to either side, is flat in the model: not one of many that stand for
/// a curved surface.
bool is_flat(const model::Primitive& primitive, const glm::dvec3& normal);

/// The vertices of a facet, model space, in no order; all of the solid's for a cap.
std::vector<glm::dvec3> vertices_of(const Context& context, const Facet& facet);

}  // namespace csgsim::emit
