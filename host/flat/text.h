#pragma once

#include <optional>
#include <string>

#include "host/flat/area.h"
#include "host/model/tree.h"

namespace csgsim::flat {

/// The arguments of OpenSCAD's text(). Strings are UTF-8.
struct Text {
  std::string text{};
  double size = 10;                 ///< about the height of capitals, model units
  std::string font{};               ///< a fontconfig pattern; empty is Liberation Sans
  std::string halign = "left";      ///< left, center or right
  std::string valign = "baseline";  ///< top, center, baseline or bottom
  double spacing = 1;               ///< factor of the distance between characters
  std::string direction{};          ///< ltr, rtl, ttb or btt; empty: as the script runs
  std::string language = "en";      ///< ISO 639 or BCP 47
  std::string script{};             ///< ISO 15924; empty: that of the characters, if they have one in common
  model::FacetControl facets{};     ///< of which curves get an eighth, at least 2 sides
};

/// The letters as OpenSCAD 2021.01 sets them, in units of 2^-16. Fonts are the system's: where the one that is asked
/// for is not installed, fontconfig chooses another, as it does for OpenSCAD. Opens csgsim_text.so when first called.
/// Throws InputError for an unknown alignment, sizes that are not finite, too much text, and fonts that cannot be read.
Area text(const Text& text);

/// The family that fontconfig has instead of what a Text's `font` names, if that is not installed. Nothing if it is, if
/// none is named but such as any font may stand for (`sans`), or if there is no font at all, which text() tells of.
std::optional<std::string> replacement_font(const std::string& font);

}  // namespace csgsim::flat
