#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "hw/division/counts.h"
#include "hw/division/display_model.h"
#include "hw/division/groups.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// The display model of a Program. Throws InputError unless the bytes are those of one.
DisplayModel display_model_of(std::span<const std::uint8_t> bytes);

/// Looks at a square that has been divided, and at what its divider had to keep at a time.
using SquareCheck = std::function<void(const isa::Segment& square, const AtHand& at_hand)>;

/// Throws InputError unless the segments of a Program with a display model are what a divider makes of that, so that
/// who watches a run can be told of them. Squares are divided in one level.
void check_division(const isa::Program& program);

/// The same. `groups`: of segments, all of them, for two levels with a list of so many entries; none for one level.
/// What `check` throws comes out.
void check_division(const isa::Program& program, std::span<const Group> groups, std::uint64_t list_entries,
                    const SquareCheck& check);

}  // namespace csgsim::division
