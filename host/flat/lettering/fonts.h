// Font lookup through fontconfig and FreeType.
// Used by module.cpp, outlines.h and shaping.h.
#pragma once

#include <ft2build.h>

#include <string>
#include FT_FREETYPE_H

namespace csgsim::flat::lettering {

/// The font that fontconfig selects for a pattern; it stays open until the process ends. An empty pattern selects
/// Liberation Sans. Throws std::runtime_error if no font is found or the font cannot be read.
FT_Face find_font(const std::string& pattern);

/// The family of the selected font if it differs from all families in the pattern. Empty if it does not differ, or if
/// the pattern names no family or only generic families such as `sans`. Throws as find_font() does.
std::string find_replacement(const std::string& pattern);

/// The font's family name for messages; `without a name` if a damaged font has none.
std::string font_name(FT_Face face);

/// Whether the font's characters are in Unicode's private use area from 0xf000, as in old symbol fonts.
bool is_symbol_font(FT_Face face);

}  // namespace csgsim::flat::lettering
