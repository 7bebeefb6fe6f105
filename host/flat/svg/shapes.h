// SVG shape elements.
// Used by svg.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat::svg {

/// The outlines of an element in its own space, to be filled by the even-odd rule; empty if the element is not drawn.
/// Coordinates that are not plain numbers, such as those with units, are read as 0, as in OpenSCAD. Throws InputError
/// for invalid elements.
std::optional<std::vector<Outline>> read_shape(pugi::xml_node element, std::size_t max_corners);

}  // namespace csgsim::flat::svg
