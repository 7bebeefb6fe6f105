#pragma once

#include <optional>
#include <string_view>

#include "host/model/tree.h"
#include "host/read/arguments.h"

namespace csgsim::read {

/// $fn, $fa and $fs, as OpenSCAD bounds them.
model::FacetControl read_facets(const Arguments& arguments);

/// A radius that the file may give as a diameter.
std::optional<double> read_radius(const Arguments& arguments, std::string_view radius, std::string_view diameter);

}  // namespace csgsim::read
