// Writes a drawing as SVG.
// Used by sim/report.
#pragma once

#include <string>
#include <string_view>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

/// An `svg` element with these attributes and a view box. Colours are attributes, so that a style sheet can override
/// them. A shape with a tip is in a group of class `pt` with the tip as its title. Texts may hold any bytes.
std::string svg_element(const Drawing& drawing, std::string_view attributes);

/// A complete SVG file.
std::string svg_file(const Drawing& drawing);

}  // namespace csgsim::plots
