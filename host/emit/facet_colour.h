#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// A facet's colour, as the colour field holds it.
std::uint32_t facet_colour(const Context& context, const Facet& facet);

/// The same if its primitive had that colour: red, green, blue in [0, 1].
std::uint32_t facet_colour(const Context& context, const Facet& facet, const glm::dvec3& colour);

}  // namespace csgsim::emit
