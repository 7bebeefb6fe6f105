#pragma once

#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::isa {

/// Of every piece that an instruction of the lines serves, in the order of the pieces.
std::vector<RowExtent> extents_of(std::span<const Segment> lines);

}  // namespace csgsim::isa
