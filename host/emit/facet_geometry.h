// Normals and vertices of facets.
// Used by host/effects and sim/studies.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// A vector in camera space: right, up, forward.
glm::dvec3 in_camera_axes(const view::Camera& camera, const glm::dvec3& vector);

/// The unit normal in model space that points out of the visible solid. Undefined for a cap, which has no half-space.
glm::dvec3 outward_normal(const Context& context, const Facet& facet);

/// outward_normal() in the primitive's local space.
glm::dvec3 local_normal(const Context& context, const Facet& facet);

/// Whether a facet with the normal `normal` (model space, either sign) is flat in the model, that is, not one of those
/// that approximate a curved surface.
bool is_flat(const model::Primitive& primitive, const glm::dvec3& normal);

/// The vertices of a facet in model space, unordered; all vertices of the solid for a cap.
std::vector<glm::dvec3> facet_vertices(const Context& context, const Facet& facet);

}  // namespace csgsim::emit
