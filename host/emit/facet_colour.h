// Flat-shaded colours of facets.
// Used by flat shading and the effects.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// The colour of a facet in the format of the colour field.
std::uint32_t facet_colour(const Context& context, const Facet& facet);

/// The same with `colour` (red, green, blue in [0, 1]) in place of the primitive's.
std::uint32_t facet_colour(const Context& context, const Facet& facet, const glm::dvec3& colour);

}  // namespace csgsim::emit
