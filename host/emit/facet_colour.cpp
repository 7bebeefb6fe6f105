#include "host/emit/facet_colour.h"

#include "host/emit/facet_geometry.h"
#include "hw/isa/host_counts.h"

namespace csgsim::emit {

namespace {

/// The mean of a facet's vertices, in camera space.
glm::dvec3 middle(const Context& context, const Facet& facet) {
  const std::vector<glm::dvec3> vertices = facet_vertices(context, facet);
  glm::dvec3 sum{0};
  for (const glm::dvec3& vertex : vertices) sum += vertex;
  const glm::dvec3 place = vertices.empty() ? context.geometry.solids[facet.primitive].box.centre()
                                            : sum / static_cast<double>(vertices.size());
  return in_camera_axes(context.view.camera, place - context.view.camera.eye);
}

}  // namespace

std::uint32_t facet_colour(const Context& context, const Facet& facet) {
  return facet_colour(context, facet, context.look.finishes[facet.primitive].colour);
}

std::uint32_t facet_colour(const Context& context, const Facet& facet, const glm::dvec3& colour) {
  const lighting::Finish& finish = context.look.finishes[facet.primitive];
  const lighting::Lighting& light = context.lighting();
  const bool is_local = light.is_local(finish.material);
  const glm::dvec3 place = is_local ? middle(context, facet) : glm::dvec3(0, 0, 1);
  const glm::dvec3 normal =
      facet.at == At::cap ? glm::dvec3(0, 0, -1) : in_camera_axes(context.view.camera, outward_normal(context, facet));
  // Drawings inside another one have reflected lights.
  const bool can_be_known =
      !is_local && context.lights == nullptr && context.nesting == 0 && context.known_colours != nullptr;
  if (!can_be_known || context.known_colours->add(normal, finish.material, colour))
    context.counted.add(&isa::Preparation::colours);
  const glm::dvec3 seen = lighting::lit_colour(light, finish.material, colour, {place, normal});
  return packed_colour(seen, context.options.colour_bits);
}

}  // namespace csgsim::emit
