// Strokes of open SVG lines.
// Used by path.h and shapes.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat::svg {

enum class Cap { butt, round, square };
enum class Join { bevel, round, miter };

/// How an open line is drawn.
struct Stroke {
  double width = 1;
  Cap cap = Cap::square;
  Join join = Join::miter;
};

/// The area covered by the line, as outlines to be filled by the even-odd rule, in units of 1e-4. Throws InputError if
/// it needs more than `max_corners` corners.
std::vector<Outline> stroke_outlines(const Outline& line, const Stroke& stroke, std::size_t max_corners);

}  // namespace csgsim::flat::svg
