#pragma once

#include <hb.h>

#include <vector>

#include "host/flat/lettering/fonts.h"
#include "host/flat/text.h"

namespace csgsim::flat::lettering {

struct Glyph {
  std::uint32_t index = 0;       ///< in the font
  hb_glyph_position_t position;  ///< in the font's units at its size
};

/// Glyphs in the order in which they are set, from left to right or from top to bottom.
struct Line {
  bool horizontal = true;
  std::vector<Glyph> glyphs;
};

/// Chooses and places glyphs for the text. The face has its size.
Line shape(const Text& text, FT_Face face);

}  // namespace csgsim::flat::lettering
