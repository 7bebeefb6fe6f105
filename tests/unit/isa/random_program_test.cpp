#include "tests/support/random_program.h"

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace csgsim::test;

namespace {

/// Checks that random Programs are valid and returns their opcodes.
std::set<isa::Opcode> opcodes_of_valid_programs(isa::ArrayShape shape) {
  std::set<isa::Opcode> opcodes;
  CHECK(rc::check("random Programs are valid", [&] {
    const auto program = *arbitrary_program(shape, 100, 2);
    isa::validate(program);
    for (const isa::Segment& segment : program.segments)
      for (const isa::Instruction& instruction : segment.instructions) opcodes.insert(instruction.opcode);
  }));
  return opcodes;
}

TEST_CASE("random Programs are valid and use every opcode") {
  for (const isa::ArrayShape shape : {isa::ArrayShape{64, 64, 72}, {1, 1, 3}, {130, 3, 4096}, {16384, 16384, 208}})
    CHECK(opcodes_of_valid_programs(shape).size() == isa::opcode_table.size());
}

TEST_CASE("random Programs for a single memory bit omit what does not fit") {
  const auto opcodes = opcodes_of_valid_programs({3, 3, 1});
  CHECK_FALSE(opcodes.contains(isa::Opcode::copy));
  CHECK(opcodes.contains(isa::Opcode::bit_and));
}

}  // namespace
