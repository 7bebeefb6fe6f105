#include "host/emit/facet_colour.h"

#include <glm/geometric.hpp>

#include "hw/isa/colour_format.h"

namespace csgsim::emit {

FacetColour::FacetColour(const Context& context, std::uint32_t primitive)
    : context_(context),
      axes_(view::basis(context.view.camera)),
      complemented_(context.complemented(primitive)),
      colour_(context.tree.primitives[primitive].colour.value_or(complemented_ ? effects::default_cut_colour
                                                                               : effects::default_colour)) {}

std::uint32_t FacetColour::shaded(const glm::dvec3& normal) const {
  const glm::dvec3 colour = effects::shade(context_.options.shading, colour_, normal);
  return isa::pack_colour({colour.r, colour.g, colour.b}, context_.options.colour_bits);
}

std::uint32_t FacetColour::of(facet::Halfspace facet) const {
  const glm::dvec3& normal = context_.scene.planes.planes()[facet.plane].normal;
  const double sign = facet.positive != complemented_ ? 1.0 : -1.0;
  return shaded(sign *
                glm::dvec3(glm::dot(normal, axes_.right), glm::dot(normal, axes_.up), glm::dot(normal, axes_.forward)));
}

std::uint32_t FacetColour::of_cap() const { return shaded({0, 0, -1}); }

}  // namespace csgsim::emit
