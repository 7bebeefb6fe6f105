#pragma once

#include <polyclipping/clipper.hpp>

#include "hw/base/work.h"

namespace csgsim::flat {

/// Closed paths that run around the same points an odd number of times, no two of whose sides lie on each other: where
/// an even number of sides do, there is none. The paths themselves if no two sides do.
///
/// Clipper searches all outlines for each place where sides lie on each other, which takes the square of their number.
ClipperLib::Paths without_overlaps(ClipperLib::Paths paths, const Work& work = {});

}  // namespace csgsim::flat
