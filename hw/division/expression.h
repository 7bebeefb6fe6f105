#pragma once

#include "hw/division/display_model.h"
#include "hw/isa/instruction.h"

namespace csgsim::division {

/// A plane as an instruction has it: without low zero bits that A and B share, and as many of C, rounded down, of which
/// no floor and no sign of the sum depends; and places by which the sum is shifted.
struct Expression {
  Plane plane;
  unsigned shift = 0;
};

/// Of a depth plane that meets a field.
Expression depth_expression(const ModelHeader& header, const Plane& plane);

/// Of a plane whose sign counts.
Expression line_expression(const Plane& plane);

/// The plane, less the end of the depth range: not negative where it is beyond that.
Plane beyond_range(const ModelHeader& header, const Plane& plane);

/// Counted from the square's corner, in so many bits.
isa::Linear linear_of(const Expression& expression, const isa::Region& square, unsigned width);

}  // namespace csgsim::division
