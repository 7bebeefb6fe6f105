#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/read/arguments.h"

namespace csgsim::read {

// Nothing if the solid is empty.

std::optional<model::Shape> read_cube(const Arguments& arguments);
std::optional<model::Shape> read_sphere(const Arguments& arguments);
std::optional<model::Shape> read_cylinder(const Arguments& arguments);

}  // namespace csgsim::read
