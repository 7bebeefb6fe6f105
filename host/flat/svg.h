// Reader of SVG drawings.
// Used by host/read and sim/web.
#pragma once

#include <string_view>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

struct SvgOptions {
  double dpi = 72;  ///< user units per inch, for page sizes without a unit
  /// Whether to centre the drawing on the origin instead of placing the page's lower left corner there.
  bool center = false;
  Work work{};
};

/// Reads an SVG file as OpenSCAD 2021.01 does, in millimetres. Shapes and paths are filled by the even-odd rule,
/// regardless of their fill and stroke, and united; lines and open paths are as wide as their strokes. Text, images and
/// uses of definitions are ignored. Arc flags need no separator after them, as in the SVG standard; OpenSCAD reads them
/// as the start of a number. Throws InputError with the line number for anything that is not valid SVG, and WorkError
/// if the work limit is exceeded.
Area read_svg(std::string_view bytes, const SvgOptions& options);

}  // namespace csgsim::flat
