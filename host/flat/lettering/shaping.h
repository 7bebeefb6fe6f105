// Text shaping with HarfBuzz.
// Used by module.cpp.
#pragma once

#include <hb.h>

#include <vector>

#include "host/flat/lettering/fonts.h"
#include "host/flat/text.h"

namespace csgsim::flat::lettering {

struct Glyph {
  std::uint32_t index = 0;       ///< glyph index in the font
  hb_glyph_position_t position;  ///< in the font's units at its size
};

/// Glyphs in typesetting order: from left to right or from top to bottom.
struct Line {
  bool horizontal = true;
  std::vector<Glyph> glyphs;
};

/// Selects and positions the glyphs of a text. The face's size must be set.
Line shape(const Text& text, FT_Face face);

}  // namespace csgsim::flat::lettering
