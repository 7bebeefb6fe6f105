#pragma once

#include <cstdint>

#include "host/emit/halfspaces.h"

namespace csgsim::emit {

/// A facet's colour, as the colour field holds it.
std::uint32_t facet_colour(const Context& context, const Facet& facet);

}  // namespace csgsim::emit
