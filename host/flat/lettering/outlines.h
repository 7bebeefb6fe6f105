#pragma once

#include <cstdint>

#include "host/flat/area.h"
#include "host/flat/lettering/fonts.h"

namespace csgsim::flat::lettering {

/// The outlines of a glyph, in FreeType's units of 1/64 pixel, every curve as so many sides. The outline is FreeType's.
Area outlines(FT_Outline& outline, std::uint32_t sides_of_curves);

}  // namespace csgsim::flat::lettering
