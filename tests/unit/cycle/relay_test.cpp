#include "sim/cycle/relay.h"

#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/cycle/number_view.h"

using namespace csgsim;
using isa::Opcode;
using systemc::Keep;

namespace {

constexpr isa::Instruction enable_all{.opcode = Opcode::enable_all};

/// F = x in two bits, which hold -2 to 1.
constexpr isa::Instruction narrow{.opcode = Opcode::edge_negative, .linear = {.a = 1, .width = 2}};

/// Executes on a row of 8 pixels.
isa::Program program_of(const std::vector<isa::Instruction>& instructions) {
  isa::Program program;
  program.segments = {{.region = {0, 0, 8, 1}, .instructions = instructions}};
  return program;
}

class Reader final : public engine::Observer {};

}  // namespace

TEST_CASE("overflows are counted at pixels enabled before the instruction") {
  const isa::Program program = program_of({enable_all, narrow, narrow, enable_all});
  cycle::Relay relay(program, {});
  relay.after_instruction({.index = 0}, test::NumberView(0b1111'1111));  // x from 2 to 7 overflow
  CHECK(relay.overflows() == 6);
  relay.after_instruction({.index = 1}, test::NumberView(0b0100'1011));  // pixels 3 and 6 overflow among these
  CHECK(relay.overflows() == 8);
  relay.after_instruction({.index = 2}, test::NumberView(0b1111'1111));
  relay.after_instruction({.index = 3}, test::NumberView(0b1111'1111));
  CHECK(relay.overflows() == 8);
}

TEST_CASE("overflows are not counted in skipped instructions") {
  const isa::Program program =
      program_of({{.opcode = Opcode::skip_if_none, .constant = 1}, narrow, narrow, enable_all});
  cycle::Relay relay(program, {});
  relay.after_instruction({.index = 0, .skipped = 1}, test::NumberView(0b1111'1111));
  CHECK(relay.overflows() == 0);
}

TEST_CASE("the intended overflow of a stripe is not counted and reads no pixels") {
  isa::Instruction stripe = narrow;
  stripe.opcode = Opcode::stripe;
  const isa::Program program = program_of({enable_all, stripe, enable_all});
  cycle::Relay relay(program, {});
  CHECK(relay.required_after(0, 0) == Keep::nothing);
  relay.after_instruction({.index = 0}, test::NumberView(0b1111'1111));
  CHECK(relay.overflows() == 0);
}

TEST_CASE("the cycle level reads only the pixels that observers and overflow counts need") {
  const isa::Program program = program_of({enable_all, narrow, enable_all});
  cycle::Relay unobserved(program, {});
  CHECK(unobserved.required_after(0, 0) == Keep::enable);
  CHECK(unobserved.required_after(0, 1) == Keep::nothing);
  CHECK(unobserved.required_after(0, 2) == Keep::nothing);
  Reader reader;
  engine::Observer* const observers[] = {&reader};
  CHECK(cycle::Relay(program, observers).required_after(0, 2) == Keep::all);
}
