// Validation of the parts of a Program.
// Used by the text reader, wire.cpp and tests.
#pragma once

#include <cstddef>

#include "hw/isa/field_role.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

// The parts of validate(Program), for readers that can point at the position of an error. Each throws InputError.

/// Checks shape, displayed field, background, depth scale and facts.
void validate_header(const Program& program);

/// Checks one named field: it lies in memory, and a field with the role colour is the displayed field. Does not check
/// that the name is unique.
void validate_field(const NamedField& named, const Program& program);

/// Checks that both rows are in the picture and in order.
void validate_extent(const RowExtent& extent, const ArrayShape& shape);

/// Checks the segment's region, not its instructions.
void validate_region(const Region& region, const ArrayShape& shape);

/// Checks an instruction in its segment, including the primitives of its origin and the range of its linear expression.
void validate_in_segment(const Instruction& instruction, const Region& region, const Program& program);

/// Checks instruction `index` of the segment together with the instructions after it: a skip ends within the segment
/// and not directly after squares; squares are followed by a linear expression of the same width whose sum is in range.
void validate_with_successors(const Segment& segment, std::size_t index);

/// Checks that no count exceeds max_prepared.
void validate_preparation(const Preparation& preparation);

/// Checks all preparations of the Program and their sum.
void validate_preparations(const Program& program);

/// Checks that the steps of a segment account for all its instructions, in a Program with a display model.
void validate_steps(const Segment& segment, const Program& program);

}  // namespace csgsim::isa
