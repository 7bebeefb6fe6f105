#include "host/emit/facet_geometry.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "host/model/shapes.h"

namespace csgsim::emit {

namespace {

/// Tolerance of a vertex's distance from its facet's plane, relative to its distance from the model's middle.
constexpr double on_plane = 1e-6;

/// A unit normal in the primitive's local space.
glm::dvec3 in_own_axes(const model::Primitive& primitive, const glm::dvec3& normal) {
  return glm::normalize(glm::transpose(glm::dmat3(primitive.transform)) * normal);
}

}  // namespace

glm::dvec3 in_camera_axes(const view::Camera& camera, const glm::dvec3& vector) {
  const view::Basis axes = view::basis(camera);
  return {glm::dot(vector, axes.right), glm::dot(vector, axes.up), glm::dot(vector, axes.forward)};
}

glm::dvec3 outward_normal(const Context& context, const Facet& facet) {
  const glm::dvec3& normal = context.geometry.planes.planes()[facet.halfspace.plane].normal;
  return (facet.halfspace.positive != context.complemented(facet.primitive) ? 1.0 : -1.0) * normal;
}

glm::dvec3 local_normal(const Context& context, const Facet& facet) {
  return in_own_axes(context.tree.primitives[facet.primitive], outward_normal(context, facet));
}

bool is_flat(const model::Primitive& primitive, const glm::dvec3& normal) {
  return model::is_flat(primitive.shape, in_own_axes(primitive, normal));
}

std::vector<glm::dvec3> facet_vertices(const Context& context, const Facet& facet) {
  const std::vector<glm::dvec3>& all = context.geometry.solids[facet.primitive].vertices;
  if (facet.at == At::cap) return all;
  const facet::Plane& plane = context.geometry.planes.planes()[facet.halfspace.plane];
  std::vector<glm::dvec3> vertices;
  for (const glm::dvec3& vertex : all) {
    const glm::dvec3 from_centre = vertex - context.geometry.planes.centre();
    const double distance = std::abs(glm::dot(plane.normal, from_centre) + plane.offset);
    if (distance <= on_plane * glm::length(from_centre)) vertices.push_back(vertex);
  }
  return vertices;
}

}  // namespace csgsim::emit
