#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat::svg {

/// The outlines of an element, of which an odd number hold a point, in its own space; nothing if it is none that is
/// drawn. Coordinates that are no numbers, as those with units, are 0 as OpenSCAD takes them, and are told in
/// `left_out`. Throws InputError.
std::optional<std::vector<Outline>> read_shape(pugi::xml_node element, std::size_t max_corners,
                                               std::set<std::string>& left_out);

}  // namespace csgsim::flat::svg
