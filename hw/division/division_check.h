#pragma once

#include <cstdint>
#include <span>

#include "hw/division/display_model.h"
#include "hw/division/groups.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// The display model of a Program. Throws InputError unless the bytes are those of one.
DisplayModel display_model_of(std::span<const std::uint8_t> bytes);

/// Throws InputError unless the segments of a Program with a display model are what a divider makes of that, so that
/// who watches a run can be told of them. Squares are divided in one level.
void check_division(const isa::Program& program);

/// The same. `groups`: of segments, all of them, for two levels with a list of so many entries; none for one level.
void check_division(const isa::Program& program, std::span<const Group> groups, std::uint64_t list_entries);

}  // namespace csgsim::division
