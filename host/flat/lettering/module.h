// Interface of the text module, which is loaded at run time.
// Used by text.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/flat/area.h"
#include "host/flat/text.h"

namespace csgsim::flat::lettering {

/// Positioned letters, or an error message. Outlines keep the direction of the font and may cross: points with a
/// nonzero winding number are filled.
struct Lettering {
  std::vector<Area> letters;
  std::string error;  ///< empty on success
};

/// The text module: its libraries (HarfBuzz, FreeType, fontconfig and their dependencies) are loaded only when needed.
struct Module {
  /// Draws a text. Divides every curve into `sides_per_curve` sides.
  Lettering (*draw)(const Text& text, std::uint32_t sides_per_curve, std::size_t max_corners);

  /// See flat::replacement_font(); also empty if no font is available.
  std::string (*replacement)(const std::string& font);
};

inline constexpr const char* module_file = "csgsim_text.so";

/// The name of the only symbol of the module, a Module. Increment its number when this file or Text changes, so that a
/// module of another version is not loaded.
inline constexpr const char* module_symbol = "csgsim_text_2";

}  // namespace csgsim::flat::lettering
