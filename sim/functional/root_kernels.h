// The kernel of the instruction `root`.
// Used by tile.
#pragma once

#include <span>

#include "sim/functional/lane_kernels.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// Executes `root` (hw/isa/opcodes.h) where enabled, on the field stored in the planes, lowest bit first. The number of
/// planes must be odd, from 3 to 61.
void execute_root(const EnabledPixels& pixels, std::span<TileBits* const> planes);

}  // namespace csgsim::functional
