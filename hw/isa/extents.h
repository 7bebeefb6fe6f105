// Row extents of pieces, computed from instructions.
// Used by host/emit and by the reader of old files.
#pragma once

#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// The row extent of each piece that occurs in the instructions of the segments, in the order of the pieces. Each
/// segment is one row of the picture.
std::vector<RowExtent> compute_row_extents(std::span<const Segment> segments);

}  // namespace csgsim::isa
