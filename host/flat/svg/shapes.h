#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat::svg {

/// The outlines of an element, of which an odd number hold a point, in its own space; nothing if it is
/// not drawn. Coordinates that are no numbers, as those with units, are 0 as OpenSCAD takes them. Throws InputError.
std::optional<std::vector<Outline>> read_shape(pugi::xml_node element, std::size_t max_corners);

}  // namespace csgsim::flat::svg
