#pragma once

#include <span>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// The Minkowski sum, in units of 2^-16, as OpenSCAD has it: of the first, and of those of the others that are not
/// empty; one area alone stays as it is. Empty if the first is, or all the others are. Throws InputError for
/// coordinates that are too large, and for too many corners, and WorkError past the limit on work.
Area minkowski(std::span<const Area> areas, const Work& work = {});

}  // namespace csgsim::flat
