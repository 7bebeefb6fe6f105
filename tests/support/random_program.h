#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <ostream>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::isa {

/// Prints a counterexample in the text form, which can be read back.
void showValue(const Program& program, std::ostream& out);

}  // namespace csgsim::isa

namespace csgsim::test {

/// Valid instructions for pixels with `memory_bits` in the given region. Every opcode that fits the memory occurs.
/// Fields are few and shared, so that values interact; widths, shifts, coefficients and constants favour their bounds;
/// F usually crosses the range of its field, and sometimes overflows its width. A skip may reach beyond its segment.
/// Squares occur only for degree 2, here and in the Programs below. Only those Programs observe the rules for the
/// instruction after squares.
rc::Gen<isa::Instruction> arbitrary_instruction(isa::ArrayShape region, std::uint32_t memory_bits,
                                                std::uint32_t primitives, unsigned degree = 1);

/// Valid Programs of one to three segments with at most `max_instructions` each, which often enable all pixels again.
/// Tests run them on several engines and compare the results.
rc::Gen<isa::Program> arbitrary_program(isa::ArrayShape shape, std::size_t max_instructions, unsigned degree = 1);

/// Removes the instructions that need a global OR.
void erase_queries(std::vector<isa::Instruction>& instructions);

/// As arbitrary_program(), for a machine that processes the picture in parts: one segment for each of
/// machines::regions. Some or all segments are empty, and none returns a result to the host; some skip if the machine
/// has a global OR. Some Programs have no colour.
rc::Gen<isa::Program> arbitrary_program_in_parts(const machines::Machine& machine, std::size_t max_instructions,
                                                 unsigned degree = 1);

}  // namespace csgsim::test
