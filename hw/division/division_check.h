// Checks that the segments of a Program match the division of its display model.
// Used by hw/multi_processor and hw/pixel_square.
#pragma once

#include <cstdint>
#include <span>

#include "hw/division/display_model.h"
#include "hw/division/groups.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// Decodes the display model of a Program. Throws InputError unless the bytes form one.
DisplayModel display_model_of(std::span<const std::uint8_t> bytes);

/// Throws InputError unless the segments of a Program match the division of its display model. The segments are then
/// what the machine will compute, so reports on them are valid. Squares are divided in one level.
void check_division(const isa::Program& program);

/// Checks a division in two levels, with a list of `list_entries` entries. `groups` contains all segments in groups; if
/// it is empty, squares are divided in one level. Throws InputError like the check of one level.
void check_division(const isa::Program& program, std::span<const Group> groups, std::uint64_t list_entries);

}  // namespace csgsim::division
