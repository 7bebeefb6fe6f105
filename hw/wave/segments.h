#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

namespace csgsim::wave {

/// The segment that holds the pixel. Throws InputError if none does.
std::uint32_t segment_of(Pixel pixel, const isa::Program& program);

/// Where a segment's region begins, as `x,y`.
std::string place_of(const isa::Segment& segment);

/// Throws InputError if tree levels are asked for, of a machine whose pixels have no multiplier trees.
void check_no_trees(const Request& request);

}  // namespace csgsim::wave
