// Removal of coincident sides before a call to Clipper.
// Used by clipping.cpp.
#pragma once

#include <polyclipping/clipper.hpp>

#include "hw/base/work.h"

namespace csgsim::flat {

/// Closed paths that enclose the same points an odd number of times as `paths`, but have no coincident sides: an odd
/// number of coincident sides leaves one side, an even number leaves none. Returns the paths unchanged if no sides
/// coincide.
///
/// Without this step Clipper searches all outlines for each pair of coincident sides, in quadratic time.
ClipperLib::Paths remove_coincident_sides(ClipperLib::Paths paths, const Work& work = {});

}  // namespace csgsim::flat
