// Row extents of pieces, computed from instructions.
// Used by host/emit and by the reader of old files.
#pragma once

#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// The row extent of each piece that occurs in the lines' instructions, in the order of the pieces.
std::vector<RowExtent> extents_of(std::span<const Segment> lines);

}  // namespace csgsim::isa
