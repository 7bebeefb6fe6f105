#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "hw/array/sequencer.h"
#include "hw/machines/clocks.h"
#include "tests/support/random_program.h"

namespace {

using csgsim::array::AluFunction;
using csgsim::array::BitStep;
using csgsim::array::Sequencer;
namespace isa = csgsim::isa;

csgsim::machines::Machine machine_with(std::uint32_t reads) {
  csgsim::machines::Machine machine;
  machine.array = {1, 1, 64};  // no latency: a question is one clock, as is its step
  machine.memory_reads = reads;
  return machine;
}

isa::Instruction some_instruction() { return *csgsim::test::arbitrary_instruction({8, 8, 64}, 64, 1); }

}  // namespace

TEST_CASE("an instruction has as many bit steps as the table has clocks, and only the last says so") {
  for (const std::uint32_t reads : {1U, 2U}) {
    CHECK(rc::check([reads] {
      const isa::Instruction instruction = some_instruction();
      Sequencer sequencer(reads);
      sequencer.begin(instruction);
      std::uint64_t steps = 0;
      while (sequencer.busy()) {
        ++steps;
        const bool last = sequencer.issue().last;
        RC_ASSERT(last == !sequencer.busy());
      }
      RC_ASSERT(steps == csgsim::machines::clocks(instruction, machine_with(reads)));
    }));
  }
}

TEST_CASE("no step reads pixel memory more often than it has ports") {
  for (const std::uint32_t reads : {1U, 2U}) {
    CHECK(rc::check([reads] {
      Sequencer sequencer(reads);
      sequencer.begin(some_instruction());
      while (sequencer.busy()) RC_ASSERT(memory_reads(sequencer.issue().pixels) <= reads);
    }));
  }
}

TEST_CASE("coefficients are sent LSB first in two's complement, with the bit's number") {
  Sequencer sequencer(1);
  sequencer.begin({.opcode = isa::Opcode::edge_negative, .linear = {.a = -2, .b = 5, .c = 1, .width = 4}});
  for (unsigned j = 0; j < 4; ++j) {
    const BitStep step = sequencer.issue();
    CHECK(step.root.token.bit == static_cast<int>(j));
    CHECK(step.root.a == (j > 0));
    CHECK(step.root.b == ((5U >> j & 1U) != 0));
    CHECK(step.root.c == (j == 0));
    CHECK((step.pixels.function == AluFunction::idle) == (j < 3));
  }
  CHECK_FALSE(sequencer.busy());
}

TEST_CASE("with one read port the first source is latched a clock before the second is read") {
  Sequencer sequencer(1);
  sequencer.begin({.opcode = isa::Opcode::bit_and, .fields = {isa::Field{3, 1}, isa::Field{4, 1}, isa::Field{5, 1}}});
  const BitStep first = sequencer.issue();
  CHECK(first.pixels.function == AluFunction::latch_x);
  CHECK(first.pixels.x == 4);
  const BitStep second = sequencer.issue();
  CHECK(second.pixels.function == AluFunction::store_and);
  CHECK(second.pixels.source == csgsim::array::OperandSource::latch);
  CHECK(second.pixels.y == 5);
  CHECK(second.pixels.write == 3);
  CHECK(second.last);
}
