#pragma once

#include <span>

#include "host/flat/area.h"

namespace csgsim::flat {

/// The Minkowski sum, in units of 2^-16, as OpenSCAD has it: of the first, and of those of the others that are not
/// empty; one area alone stays as it is. Empty if the first is, or all the others are. Throws InputError for
/// coordinates that are too large, and for too many corners.
Area minkowski(std::span<const Area> areas);

}  // namespace csgsim::flat
