#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/flat/area.h"
#include "host/flat/text.h"

namespace csgsim::flat::lettering {

/// Letters in their places, or why there are none. Their outlines run as their font has them, and may cross: what they
/// run around more often one way than the other is ink.
struct Lettering {
  std::vector<Area> letters;
  std::string error;  ///< empty if all went well
};

/// The module of text, whose libraries (HarfBuzz, FreeType, fontconfig and theirs) few runs need.
struct Module {
  /// Every curve becomes `sides_of_curves` sides.
  Lettering (*draw)(const Text& text, std::uint32_t sides_of_curves, std::size_t max_corners);

  /// See flat::replacement_font(); empty also where there is no font to be had.
  std::string (*replacement)(const std::string& font);
};

inline constexpr const char* module_file = "csgsim_text.so";

/// The name of the module's only symbol, a Module. It changes with this file and with Text, so that no other version's
/// is taken.
inline constexpr const char* module_symbol = "csgsim_text_2";

}  // namespace csgsim::flat::lettering
