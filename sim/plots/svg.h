#pragma once

#include <string>
#include <string_view>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

/// The drawing as an element `svg` with these attributes and a view box. Colours are attributes, so that a style sheet
/// can replace them; what has a tip is in a group of the class `pt` with the tip as its title. Texts may be any bytes.
std::string svg_element(const Drawing& drawing, std::string_view attributes);

/// The same as a whole file.
std::string svg_file(const Drawing& drawing);

}  // namespace csgsim::plots
