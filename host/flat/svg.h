#pragma once

#include <string_view>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

struct SvgOptions {
  double dpi = 72;      ///< units without a name in an inch, where the page says its size in them
  bool center = false;  ///< about the origin, instead of the page's lower left corner there
  Work work{};
};

/// What OpenSCAD 2021.01 draws of an SVG file, in millimetres: shapes and paths filled, whatever they say of fill and
/// stroke, each by the rule of odd and even, and all of them united; lines and open paths as wide as their strokes.
/// Text, images and uses of definitions are left out. Flags of arcs need no space after them, as SVG has it; OpenSCAD
/// takes them for the beginnings of numbers. Throws InputError, with the line in the file, for what is not SVG, and
/// WorkError past the limit on work.
Area read_svg(std::string_view bytes, const SvgOptions& options);

}  // namespace csgsim::flat
