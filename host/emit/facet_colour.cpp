#include "host/emit/facet_colour.h"

#include <glm/geometric.hpp>

#include "hw/isa/colour_format.h"

namespace csgsim::emit {

namespace {

/// Out of the solid that is seen, in eye space.
glm::dvec3 outward(const Context& context, const Facet& facet) {
  if (facet.at == At::cap) return {0, 0, -1};
  const view::Basis axes = view::basis(context.view.camera);
  const glm::dvec3& normal = context.scene.planes.planes()[facet.halfspace.plane].normal;
  const double sign = facet.halfspace.positive != context.complemented(facet.primitive) ? 1.0 : -1.0;
  return sign * glm::dvec3(glm::dot(normal, axes.right), glm::dot(normal, axes.up), glm::dot(normal, axes.forward));
}

}  // namespace

std::uint32_t facet_colour(const Context& context, const Facet& facet) {
  const glm::dvec3 own = context.tree.primitives[facet.primitive].colour.value_or(
      context.complemented(facet.primitive) ? effects::default_cut_colour : effects::default_colour);
  const glm::dvec3 colour = effects::shade(context.options.shading, own, outward(context, facet));
  return isa::pack_colour({colour.r, colour.g, colour.b}, context.options.colour_bits);
}

}  // namespace csgsim::emit
