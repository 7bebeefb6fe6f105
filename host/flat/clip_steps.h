#pragma once

#include <polyclipping/clipper.hpp>

#include "hw/base/work.h"

namespace csgsim::flat {

/// Charges what Clipper takes to combine closed paths, before it begins: it goes from one height of a corner to the
/// next with all sides that are there, and looks at each place where two of them cross. Throws WorkError past the
/// limit on work.
void charge_clipping(const ClipperLib::Paths& paths, const Work& work);

}  // namespace csgsim::flat
