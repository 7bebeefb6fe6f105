#pragma once

#include <cstddef>

#include "hw/isa/field_role.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// The parts of validate(Program), for readers that can point at the place. Each throws InputError.

/// Shape, what is shown, depth scale and facts.
void validate_header(const Program& program);

/// One named field, but for the uniqueness of its name: it lies in memory, and if it is said to be the colour, it is
/// the one that is shown.
void validate_field(const NamedField& named, const Program& program);

/// Rows of the picture, the last not above the first.
void validate_extent(const RowExtent& extent, const ArrayShape& shape);

/// The segment's region, not its instructions.
void validate_region(const Region& region, const ArrayShape& shape);

/// An instruction where it stands: also the primitives of its origin and the range of its linear expression.
void validate_placed(const Instruction& instruction, const Region& region, const Program& program);

/// What the instruction of that number in its segment asks of those that follow it: that a skip stays in the segment
/// and does not end behind squares; that a linear expression of the same width and a sum in range follow on squares.
void validate_ahead(const Segment& segment, std::size_t index);

/// That the counts are no more than most_prepared.
void validate_preparation(const Preparation& preparation);

/// The same of all that a Program has, and of their sum.
void validate_preparations(const Program& program);

/// That the steps of a segment write its instructions, in a Program with a display model.
void validate_steps(const Segment& segment, const Program& program);

}  // namespace csgsim::isa
