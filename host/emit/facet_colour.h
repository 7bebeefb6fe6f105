// Flat-shaded colours of facets.
// Used by host/effects.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <set>

#include "host/emit/halfspaces.h"
#include "host/scene/scene.h"

namespace csgsim::emit {

/// The colours that the host has computed for a frame. Where light depends on the normal alone, facets with the same
/// normal, material and colour share one.
class KnownColours {
 public:
  /// Adds a colour, identified by what it is computed from. Returns whether it is new.
  bool add(const glm::dvec3& normal, const scene::Material& material, const glm::dvec3& colour) {
    return keys_
        .insert({normal.x, normal.y, normal.z, material.ambient, material.diffuse, material.specular,
                 material.shininess, material.mirror, colour.x, colour.y, colour.z})
        .second;
  }

 private:
  std::set<std::array<double, 11>> keys_;
};

/// The colour of a facet in the format of the colour field.
std::uint32_t facet_colour(const Context& context, const Facet& facet);

/// The colour of a facet of a primitive with `colour` (red, green, blue in [0, 1]), in the format of the colour field.
std::uint32_t facet_colour(const Context& context, const Facet& facet, const glm::dvec3& colour);

}  // namespace csgsim::emit
