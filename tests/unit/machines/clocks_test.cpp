#include "hw/machines/clocks.h"

#include "hw/isa/opcodes.h"
#include "hw/pixel_planes/kind.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;

namespace {

machines::Machine machine(std::uint32_t memory_reads) {
  machines::Machine result = machines::blank_machine(pixel_planes::kind);
  result.array = {512, 512, 72};
  result.memory_reads = memory_reads;
  return result;
}

std::uint64_t clocks(Opcode opcode, Field first = {}, Field second = {}, Field third = {},
                     std::uint32_t memory_reads = 1) {
  Instruction instruction;
  instruction.opcode = opcode;
  instruction.fields = {first, second, third};
  return machines::clocks(instruction, machine(memory_reads));
}

std::uint64_t linear_clocks(Opcode opcode, Field field, std::uint16_t width) {
  Instruction instruction;
  instruction.opcode = opcode;
  instruction.fields[0] = field;
  instruction.linear = {.a = 1, .b = -2, .c = 3, .width = width, .shift = 12};
  return machines::clocks(instruction, machine(1));
}

}  // namespace

TEST_CASE("the evaluator's latency is one clock per level of both trees") {
  const auto latency = [](std::uint32_t width, std::uint32_t height) {
    machines::Machine one = machine(1);
    one.array = {width, height, 72};
    return machines::evaluator_latency(one);
  };
  CHECK(latency(512, 512) == 9 + 9);
  CHECK(latency(1, 1) == 0);
  CHECK(latency(2, 1) == 1);
  CHECK(latency(3, 5) == 2 + 3);
  CHECK(latency(128, 128) == 7 + 7);
  CHECK(latency(513, 512) == 10 + 9);
}

TEST_CASE("with fewer registers a clock covers several levels of one tree") {
  const auto latency = [](std::uint32_t width, std::uint32_t height, std::uint32_t levels) {
    machines::Machine one = machine(1);
    one.array = {width, height, 72};
    one.register_levels = levels;
    return machines::evaluator_latency(one);
  };
  CHECK(latency(512, 512, 2) == 5 + 5);
  CHECK(latency(512, 512, 3) == 3 + 3);
  CHECK(latency(512, 512, 8) == 2 + 2);
  CHECK(latency(512, 512, 9) == 1 + 1);
  CHECK(latency(512, 512, 16) == 1 + 1);
  CHECK(latency(1, 512, 4) == 3);
  CHECK(latency(1, 1, 4) == 0);
  machines::Machine deep = machine(1);
  deep.register_levels = 4;
  CHECK(machines::clocks({.opcode = Opcode::global_or}, deep) == 1 + 3 + 3);
  CHECK(machines::clocks({.opcode = Opcode::edge_negative, .linear = {.a = 1, .width = 20}}, deep) == 20);
}

TEST_CASE("an instruction on the enable register takes one clock") {
  CHECK(clocks(Opcode::enable_all) == 1);
  CHECK(clocks(Opcode::enable_invert) == 1);
  for (const Opcode opcode : {Opcode::enable_load, Opcode::enable_and, Opcode::enable_and_not, Opcode::enable_or,
                              Opcode::enable_xor, Opcode::enable_store})
    CHECK(clocks(opcode, {7, 1}) == 1);
}

TEST_CASE("a linear expression that is only compared or loaded takes one clock per bit") {
  CHECK(linear_clocks(Opcode::edge_not_negative, {}, 22) == 22);
  CHECK(linear_clocks(Opcode::edge_negative, {}, 1) == 1);
  CHECK(linear_clocks(Opcode::stripe, {}, 1) == 1);
  CHECK(linear_clocks(Opcode::stripe, {}, 13) == 13);
  for (const Opcode opcode : {Opcode::linear_ge, Opcode::linear_gt, Opcode::linear_le, Opcode::linear_lt,
                              Opcode::linear_eq, Opcode::load_linear})
    CHECK(linear_clocks(opcode, {0, 20}, 34) == 34);
}

TEST_CASE("a linear expression that is compared and kept takes two clocks per bit") {
  CHECK(linear_clocks(Opcode::keep_max, {0, 20}, 34) == 68);
  CHECK(linear_clocks(Opcode::keep_min, {0, 20}, 33) == 66);
}

TEST_CASE("writing a field from one source takes one clock per bit") {
  CHECK(clocks(Opcode::set_constant, {0, 24}) == 24);
  CHECK(clocks(Opcode::copy, {0, 20}, {20, 20}) == 20);
  CHECK(clocks(Opcode::bit_not, {0, 1}, {1, 1}) == 1);
}

TEST_CASE("two source bits take two clocks with one memory read per clock and otherwise one") {
  for (const Opcode opcode : {Opcode::field_lt, Opcode::field_le, Opcode::field_eq}) {
    CHECK(clocks(opcode, {0, 20}, {20, 20}) == 40);
    CHECK(clocks(opcode, {0, 20}, {20, 20}, {}, 2) == 20);
  }
  for (const Opcode opcode : {Opcode::bit_and, Opcode::bit_or, Opcode::bit_xor, Opcode::bit_and_not}) {
    CHECK(clocks(opcode, {0, 1}, {1, 1}, {2, 1}) == 2);
    CHECK(clocks(opcode, {0, 1}, {1, 1}, {2, 1}, 2) == 1);
  }
}

TEST_CASE("a sum takes the clocks of its target however narrow its source") {
  for (const std::uint16_t width : {std::uint16_t{1}, std::uint16_t{7}, std::uint16_t{20}}) {
    CAPTURE(width);
    CHECK(clocks(Opcode::add, {0, 20}, {20, width}) == 40);
    CHECK(clocks(Opcode::add, {0, 20}, {20, width}, {}, 2) == 20);
  }
  machines::Machine wide = machine(1);
  wide.alu_bits = 8;
  CHECK(machines::clocks({.opcode = Opcode::add, .fields = {Field{0, 20}, Field{20, 3}}}, wide) == 6);
}

TEST_CASE("each bit of a root takes three clocks plus one or two per preceding bit") {
  const auto expected = [](std::uint64_t bits, std::uint64_t of_each_before) {
    std::uint64_t clocks = 0;
    for (std::uint64_t bit = 0; bit < bits; ++bit) clocks += 3 + of_each_before * bit;
    return clocks;
  };
  for (std::uint16_t w = 1; w <= 30; ++w) {
    CAPTURE(w);
    const auto width = static_cast<std::uint16_t>(2 * w + 1);
    CHECK(clocks(Opcode::root, {3, width}) == expected(w, 2));
    CHECK(clocks(Opcode::root, {3, width}, {}, {}, 2) == expected(w, 1));
  }
  machines::Machine wide = machine(1);
  wide.alu_bits = 8;
  CHECK(machines::clocks({.opcode = Opcode::root, .fields = {Field{0, 41}}}, wide) == 20 * 20 + 2 * 20);
}

TEST_CASE("squares take one clock and adding F to a field takes the expression's width") {
  CHECK(machines::clocks({.opcode = Opcode::squares, .linear = {.a = 1, .width = 40}}, machine(1)) == 1);
  CHECK(linear_clocks(Opcode::linear_plus, {0, 20}, 40) == 40);
  CHECK(linear_clocks(Opcode::linear_minus, {0, 20}, 40) == 40);
}

TEST_CASE("wider trees deliver several bits per clock and the remainder last") {
  Instruction instruction;
  instruction.fields[0] = {0, 20};
  instruction.linear = {.a = 1, .b = -2, .c = 3, .width = 34, .shift = 12};
  const auto with = [&](Opcode opcode, std::uint32_t tree_bits) {
    instruction.opcode = opcode;
    machines::Machine wide = machine(1);
    wide.alu_bits = 32;
    wide.evaluator_bits = tree_bits;
    return machines::clocks(instruction, wide);
  };
  for (const Opcode opcode : {Opcode::edge_negative, Opcode::linear_ge, Opcode::load_linear, Opcode::linear_plus}) {
    CHECK(with(opcode, 1) == 34);
    CHECK(with(opcode, 2) == 17);
    CHECK(with(opcode, 4) == 9);
    CHECK(with(opcode, 17) == 2);
    CHECK(with(opcode, 32) == 2);
  }
  // Each pass starts with one extra clock.
  CHECK(with(Opcode::keep_max, 4) == 18);
  CHECK(with(Opcode::keep_min, 32) == 4);
  // Unaffected: the squares before a stream, roots and queries.
  CHECK(with(Opcode::squares, 32) == 1);
  CHECK(with(Opcode::global_or, 32) == 1 + 18);
  instruction.fields[0] = {0, 41};
  CHECK(with(Opcode::root, 32) == 20 * 20 + 2 * 20);
}

TEST_CASE("a wider ALU processes several bits per clock and the remainder last") {
  Instruction instruction;
  instruction.fields = {Field{0, 20}, Field{20, 20}, Field{40, 20}};
  const auto with = [&](Opcode opcode, std::uint32_t alu_bits, std::uint32_t memory_reads = 1) {
    instruction.opcode = opcode;
    machines::Machine wide = machine(memory_reads);
    wide.alu_bits = alu_bits;
    return machines::clocks(instruction, wide);
  };
  CHECK(with(Opcode::copy, 1) == 20);
  CHECK(with(Opcode::copy, 2) == 10);
  CHECK(with(Opcode::copy, 8) == 3);
  CHECK(with(Opcode::set_constant, 32) == 1);
  CHECK(with(Opcode::xor_constant, 19) == 2);
  CHECK(with(Opcode::bit_and, 8) == 6);
  CHECK(with(Opcode::bit_and, 8, 2) == 3);
  CHECK(with(Opcode::field_lt, 20) == 2);
}

TEST_CASE("a wider ALU speeds up neither linear expressions nor enable nor queries") {
  machines::Machine wide = machine(1);
  wide.alu_bits = 16;
  Instruction instruction;
  instruction.opcode = Opcode::keep_max;
  instruction.fields[0] = {0, 20};
  instruction.linear = {.a = 1, .b = -2, .c = 3, .width = 34, .shift = 12};
  CHECK(machines::clocks(instruction, wide) == 68);
  CHECK(machines::clocks({.opcode = Opcode::enable_load, .fields = {Field{7, 1}}}, wide) == 1);
  CHECK(machines::clocks({.opcode = Opcode::global_or}, wide) == 1 + 18);
}

TEST_CASE("a global-OR query takes one clock plus the latency of the trees") {
  CHECK(clocks(Opcode::global_or) == 1 + 18);
  CHECK(clocks(Opcode::skip_if_none) == 1 + 18);
}

TEST_CASE("the clocks of a Program are computed as if no instruction were skipped") {
  isa::Program program;
  program.shape = {512, 512, 72};
  const Instruction all{Opcode::enable_all, {}, {}, 0, {}};
  const Instruction skip{Opcode::skip_if_none, {}, {}, 1, {}};
  program.segments = {{{0, 0, 512, 512}, {skip, all, all}}, {{0, 0, 8, 8}, {all}}};
  CHECK(machines::clocks(program.segments[0].instructions, machine(1)) == 19 + 2);
  // The first word takes four clocks from the request to the first clear; clearing a segment takes one.
  CHECK(machines::clocks(program, machine(1)) == 4 + 1 + 19 + 2 + 1 + 1 + 18);
}
