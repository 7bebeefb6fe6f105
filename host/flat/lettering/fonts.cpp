#include "host/flat/lettering/fonts.h"

#include <fontconfig/fontconfig.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include FT_TRUETYPE_IDS_H

namespace csgsim::flat::lettering {

namespace {

constexpr const char* default_font = "Liberation Sans:style=Regular";

struct DestroyFont {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
};
using Pattern = std::unique_ptr<FcPattern, DestroyFont>;
using Configuration = std::unique_ptr<FcConfig, DestroyFont>;

using Names = std::vector<std::string>;

struct FontFile {
  std::string path;
  int index = 0;
  std::string replacement;  ///< family of the font, if it is not one of the requested families
};

FcConfig* configuration() {
  static const Configuration config(FcInitLoadConfigAndFonts());
  if (!config) throw std::runtime_error("fontconfig cannot be initialized; run fc-match to see why");
  return config.get();
}

FT_Library library() {
  static const FT_Library opened = [] {
    FT_Library made = nullptr;
    return FT_Init_FreeType(&made) == 0 ? made : nullptr;
  }();
  if (opened == nullptr) throw std::runtime_error("FreeType cannot be initialized; check its installation");
  return opened;
}

Names families(FcPattern* pattern) {
  Names names;
  FcChar8* name = nullptr;
  for (int i = 0; FcPatternGetString(pattern, FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    names.emplace_back(reinterpret_cast<const char*>(name));
  }
  return names;
}

/// Normalizes a family name as fontconfig does: ignores case and blanks.
std::string plain(const std::string& family) {
  std::string letters;
  for (const char c : family) {
    if (c != ' ') letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return letters;
}

/// Whether the family is generic, so that any font matches it.
bool is_generic(const std::string& family) {
  constexpr std::array<std::string_view, 9> generic{"sans",      "sans-serif", "sansserif", "serif",    "mono",
                                                    "monospace", "cursive",    "fantasy",   "system-ui"};
  return std::find(generic.begin(), generic.end(), plain(family)) != generic.end();
}

/// The first family of the selected font; empty if one of the requested families matches.
std::string replacement(const Names& requested, const Names& found) {
  const auto is_found = [&](const std::string& one) {
    return std::any_of(found.begin(), found.end(),
                       [&](const std::string& other) { return plain(one) == plain(other); });
  };
  const bool is_right =
      requested.empty() || std::any_of(requested.begin(), requested.end(),
                                       [&](const std::string& one) { return is_generic(one) || is_found(one); });
  return is_right || found.empty() ? "" : found.front();
}

FontFile match(const std::string& name) {
  const Pattern pattern(FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())));
  if (!pattern) throw std::runtime_error("font \"" + name + "\" is not a font name; run fc-match to look up fonts");
  const Names requested = families(pattern.get());
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(configuration(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult unused{};
  const Pattern found(FcFontMatch(configuration(), pattern.get(), &unused));
  FcChar8* path = nullptr;
  int index = 0;
  if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &path) != FcResultMatch ||
      FcPatternGetInteger(found.get(), FC_INDEX, 0, &index) != FcResultMatch) {
    throw std::runtime_error("no font is installed; install one, such as fonts-liberation");
  }
  return {reinterpret_cast<const char*>(path), index, replacement(requested, families(found.get()))};
}

bool select(FT_Face face, int platform, std::optional<int> encoding) {
  for (int i = 0; i < face->num_charmaps; ++i) {
    const FT_CharMap map = face->charmaps[i];
    if (map->platform_id == platform && map->encoding_id == encoding.value_or(map->encoding_id) &&
        FT_Set_Charmap(face, map) == 0) {
      return true;
    }
  }
  return false;
}

/// Selects the Unicode table if the font has one, otherwise the closest alternative.
void select_characters(FT_Face face) {
  constexpr std::array<std::pair<int, std::optional<int>>, 7> others{{{TT_PLATFORM_MICROSOFT, TT_MS_ID_UNICODE_CS},
                                                                      {TT_PLATFORM_ISO, TT_ISO_ID_10646},
                                                                      {TT_PLATFORM_APPLE_UNICODE, std::nullopt},
                                                                      {TT_PLATFORM_MICROSOFT, TT_MS_ID_SYMBOL_CS},
                                                                      {TT_PLATFORM_MACINTOSH, TT_MAC_ID_ROMAN},
                                                                      {TT_PLATFORM_ISO, TT_ISO_ID_8859_1},
                                                                      {TT_PLATFORM_ISO, TT_ISO_ID_7BIT_ASCII}}};
  if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0) return;
  for (const auto& [platform, encoding] : others) {
    if (select(face, platform, encoding)) return;
  }
  throw std::runtime_error("font " + font_name(face) + " has no character table in a known encoding; use another font");
}

FT_Face open(const FontFile& file) {
  FT_Face face = nullptr;
  if (FT_New_Face(library(), file.path.c_str(), file.index, &face) != 0) {
    throw std::runtime_error("font " + file.path + " cannot be read; install it again, or use another font");
  }
  select_characters(face);
  return face;
}

/// Removes leading and trailing white space.
std::string trimmed(const std::string& text) {
  constexpr std::string_view white = " \t\n\v\f\r";
  const std::size_t first = text.find_first_not_of(white);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(white) - first + 1);
}

struct OpenedFont {
  FT_Face face = nullptr;
  std::string replacement;
};

const OpenedFont& opened_font(const std::string& pattern) {
  static std::map<std::string, OpenedFont> opened;
  std::string name = trimmed(pattern);
  if (name.empty()) name = default_font;
  const auto known = opened.find(name);
  if (known != opened.end()) return known->second;
  const FontFile file = match(name);
  return opened.emplace(name, OpenedFont{open(file), file.replacement}).first->second;
}

}  // namespace

FT_Face find_font(const std::string& pattern) { return opened_font(pattern).face; }

std::string find_replacement(const std::string& pattern) {
  return trimmed(pattern).empty() ? "" : opened_font(pattern).replacement;
}

std::string font_name(FT_Face face) { return face->family_name == nullptr ? "without a name" : face->family_name; }

bool is_symbol_font(FT_Face face) {
  if (face->charmap->platform_id != TT_PLATFORM_MICROSOFT || face->charmap->encoding_id != TT_MS_ID_SYMBOL_CS) {
    return false;
  }
  FT_UInt glyph = 0;
  const FT_ULong first = FT_Get_First_Char(face, &glyph);
  return glyph != 0 && first >= 0xf000;
}

}  // namespace csgsim::flat::lettering
