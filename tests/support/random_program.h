#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <ostream>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::isa {

/// A counterexample is shown in the text form, ready to be read back.
void showValue(const Program& program, std::ostream& out);

}  // namespace csgsim::isa

namespace csgsim::test {

/// Valid instructions for pixels of that memory in a region of that shape. Every opcode that fits the memory occurs;
/// fields are few and shared, so that values meet; widths, shifts, coefficients and constants prefer their bounds; F
/// mostly crosses the range of the field it meets, and sometimes does not fit its width. A skip may reach beyond the
/// segment that it is put into. Squares are only for evaluators of degree 2, here and in the Programs below, and what
/// they ask of the instruction after them only those Programs keep.
rc::Gen<isa::Instruction> arbitrary_instruction(isa::ArrayShape region, std::uint32_t memory_bits,
                                                std::uint32_t primitives, unsigned degree = 1);

/// Valid Programs of one to three segments with at most so many instructions each, often enabling pixels anew, for
/// engines to be held against each other.
rc::Gen<isa::Program> arbitrary_program(isa::ArrayShape shape, std::size_t max_instructions, unsigned degree = 1);

/// For a machine without a global OR.
void erase_questions(std::vector<isa::Instruction>& instructions);

/// As those, for a machine that works on parts of the picture: a segment for each of machines::regions. Some, sometimes
/// all, have no instructions, and none asks for an answer to the host; some skip, if the
/// machine has a global OR. Some Programs have no colour.
rc::Gen<isa::Program> arbitrary_program_in_parts(const machines::Machine& machine, std::size_t max_instructions,
                                                 unsigned degree = 1);

}  // namespace csgsim::test
