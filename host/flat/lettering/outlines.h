// Conversion of FreeType glyph outlines to polygons.
// Used by module.cpp.
#pragma once

#include <cstdint>

#include "host/flat/area.h"
#include "host/flat/lettering/fonts.h"

namespace csgsim::flat::lettering {

/// The outlines of a FreeType glyph, in units of 1/64 pixel. Every curve is divided into `sides_per_curve` sides.
Area outlines(FT_Outline& outline, std::uint32_t sides_per_curve);

}  // namespace csgsim::flat::lettering
