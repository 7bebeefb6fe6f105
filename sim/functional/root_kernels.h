#pragma once

#include <span>

#include "sim/functional/lane_kernels.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// Where enabled: takes the root (hw/isa/opcodes.h) of the field that these planes hold, the lowest bit first; they are
/// of an odd number, 3 to 61.
void take_root(const Enabled& pixels, std::span<TileBits* const> planes);

}  // namespace csgsim::functional
