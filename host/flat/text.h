// OpenSCAD's text().
// Used by lettering/module.h, lettering/shaping.h and host/read.
#pragma once

#include <optional>
#include <string>

#include "host/flat/area.h"
#include "host/model/tree.h"

namespace csgsim::flat {

/// The arguments of OpenSCAD's text(). Strings are UTF-8.
struct Text {
  std::string text{};
  double size = 10;                 ///< approximate height of capitals, in model units
  std::string font{};               ///< fontconfig pattern; if empty, Liberation Sans
  std::string halign = "left";      ///< left, center or right
  std::string valign = "baseline";  ///< top, center, baseline or bottom
  double spacing = 1;               ///< scale of the distance between characters
  std::string direction{};          ///< ltr, rtl, ttb or btt; if empty, the direction of the script
  std::string language = "en";      ///< ISO 639 or BCP 47
  std::string script{};             ///< ISO 15924; if empty, the common script of the characters, if they have one
  model::FacetControl facets{};     ///< a curve gets an eighth of the fragments of a circle, but at least 2 sides
};

/// The letters as OpenSCAD 2021.01 sets them, in units of 2^-16. Fonts are those of the system: if a font is not
/// installed, fontconfig substitutes another font, as it does for OpenSCAD. Loads csgsim_text.so on the first call.
/// Throws InputError for an unknown alignment, sizes that are not finite, too much text, and fonts that cannot be read.
Area text(const Text& text);

/// The family that fontconfig substitutes for the `font` of a Text. Empty if that font is installed, if it names no
/// family or only generic families such as `sans`, or if no font is available, in which case text() throws.
std::optional<std::string> replacement_font(const std::string& font);

}  // namespace csgsim::flat
