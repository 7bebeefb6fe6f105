// Work charged for calls to Clipper.
// Used by clipping.cpp, offset.cpp and host/solids.
#pragma once

#include <polyclipping/clipper.hpp>

#include "hw/base/work.h"

namespace csgsim::flat {

/// Charges the cost of combining closed paths with Clipper, before Clipper starts. Clipper sweeps from one corner
/// height to the next over all active sides, and visits each crossing of two sides. Throws WorkError if the work limit
/// is exceeded.
void charge_clipping(const ClipperLib::Paths& paths, const Work& work);

}  // namespace csgsim::flat
