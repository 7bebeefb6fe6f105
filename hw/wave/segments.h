// Segments that contain probed pixels, for waves.
// Used by hw/multi_processor, hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

namespace csgsim::wave {

/// Number of the segment that contains the pixel. Throws InputError if there is none.
std::uint32_t segment_of(Pixel pixel, const isa::Program& program);

/// Top left corner of a segment's region, as `x,y`.
std::string corner_text(const isa::Segment& segment);

/// For machines without multiplier trees: throws InputError if tree levels are requested.
void check_no_tree_levels(const Request& request);

}  // namespace csgsim::wave
