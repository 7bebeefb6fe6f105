// Linear expressions of planes, as encoded in instructions.
// Used by hw/multi_processor.
#pragma once

#include "hw/division/display_model.h"
#include "hw/isa/instruction.h"

namespace csgsim::division {

/// A plane as encoded in an instruction. The low zero bits that A and B share are dropped, with the same number of low
/// bits of C, because neither the floor nor the sign of the sum depends on them. `shift` is the number of fraction bits
/// that remain.
struct Expression {
  Plane plane;
  unsigned shift = 0;
};

/// Expression of a depth plane that is compared with a field.
Expression depth_expression(const ModelHeader& header, const Plane& plane);

/// Expression of a plane whose sign is tested.
Expression line_expression(const Plane& plane);

/// The plane's depth minus the end of the depth range: not negative where the plane is beyond the range.
Plane depth_range_excess(const ModelHeader& header, const Plane& plane);

/// The expression with its origin at the square's corner, `width_bits` bits wide.
isa::Linear linear_of(const Expression& expression, const isa::Region& square, unsigned width_bits);

}  // namespace csgsim::division
