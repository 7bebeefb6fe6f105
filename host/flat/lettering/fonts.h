#pragma once

#include <ft2build.h>

#include <string>
#include FT_FREETYPE_H

namespace csgsim::flat::lettering {

/// The font that fontconfig has for a pattern, open until the process ends. An empty pattern is Liberation Sans. Throws
/// std::runtime_error if there is none or it cannot be read.
FT_Face find_font(const std::string& pattern);

/// The family of that font where it is none that the pattern names; empty where it is, where the pattern names none, or
/// only what any font may stand for, as `sans`. Throws as find_font() does.
std::string replacement_of(const std::string& pattern);

/// As messages name it: a damaged font may have no name.
std::string name_of(FT_Face face);

/// Whether its characters are in the page of Unicode for private use, from 0xf000, as those of old symbol fonts are.
bool is_symbol_font(FT_Face face);

}  // namespace csgsim::flat::lettering
