#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/isa/sample.h"

using namespace csgsim;
using namespace csgsim::isa;

namespace {

using namespace test;

constexpr std::uint32_t memory_bits = 72;

std::string refusal_of(const Instruction& instruction) {
  return refusal([&] { validate(instruction, memory_bits); });
}

std::string refusal_of(const Program& program) {
  return refusal([&] { validate(program); });
}

/// An instruction with the given fields, valid for opcodes that take only fields.
Instruction on(Opcode opcode, Field first, Field second = {}, Field third = {}) {
  return {opcode, {first, second, third}, {}, 0, {}};
}

Instruction streaming(Opcode opcode, Field field, std::uint16_t width, std::uint16_t shift = 0) {
  return {opcode, {field}, {1, 2, 3, width, shift}, 0, {}};
}

TEST_CASE("the sample Program is valid") { CHECK(refusal_of(sample_program()).empty()); }

TEST_CASE("an opcode outside the table is invalid") {
  Instruction instruction;
  instruction.opcode = static_cast<Opcode>(opcode_table.size());
  CHECK(contains(refusal_of(instruction), "opcode " + std::to_string(opcode_table.size()) + " is undefined"));
}

TEST_CASE("a purpose outside the table is invalid") {
  Instruction instruction;
  instruction.origin.purpose = static_cast<Purpose>(purpose_table.size());
  CHECK(contains(refusal_of(instruction), "purpose 7 is undefined"));
}

TEST_CASE("members of an instruction that its opcode does not use must be zero") {
  CHECK_FALSE(refusal_of(on(Opcode::enable_all, {0, 1})).empty());
  CHECK_FALSE(refusal_of(on(Opcode::enable_load, {0, 1}, {3, 0})).empty());
  CHECK_FALSE(refusal_of(on(Opcode::copy, {0, 1}, {1, 1}, {2, 1})).empty());
  CHECK_FALSE(refusal_of({Opcode::enable_all, {}, {1, 0, 0, 0, 0}, 0, {}}).empty());
  CHECK_FALSE(refusal_of({Opcode::enable_all, {}, {}, 1, {}}).empty());
  CHECK_FALSE(refusal_of({Opcode::linear_ge, {{{0, 1}, {4, 1}}}, {0, 0, 0, 8, 0}, 0, {}}).empty());
}

TEST_CASE("fields must lie in the memory and have 1 to 32 bits") {
  CHECK(refusal_of(on(Opcode::set_constant, {40, 32})).empty());
  CHECK(refusal_of(on(Opcode::set_constant, {71, 1})).empty());
  CHECK(contains(refusal_of(on(Opcode::set_constant, {41, 32})), "outside the 72 memory bits"));
  CHECK(contains(refusal_of(on(Opcode::set_constant, {65535, 1})), "outside the 72 memory bits"));
  CHECK(contains(refusal_of(on(Opcode::set_constant, {0, 0})), "0 bits wide"));
  CHECK(contains(refusal_of(on(Opcode::set_constant, {0, 33})), "33 bits wide"));
}

TEST_CASE("enable instructions take single bits") {
  CHECK(refusal_of(on(Opcode::enable_store, {5, 1})).empty());
  CHECK(contains(refusal_of(on(Opcode::enable_store, {5, 2})), "single bit"));
}

TEST_CASE("fields of a bit instruction may coincide but not overlap in part") {
  CHECK(refusal_of(on(Opcode::bit_and, {5, 1}, {5, 1}, {5, 1})).empty());
  CHECK(refusal_of(on(Opcode::bit_xor, {0, 32}, {0, 32}, {32, 32})).empty());
  CHECK(refusal_of(on(Opcode::bit_or, {0, 9}, {20, 9}, {20, 9})).empty());
  CHECK(refusal_of(on(Opcode::bit_not, {8, 4}, {4, 4})).empty());
  for (const Opcode opcode : {Opcode::bit_and, Opcode::bit_or, Opcode::bit_xor, Opcode::bit_and_not}) {
    CHECK(contains(refusal_of(on(opcode, {0, 8}, {0, 8}, {1, 8})), "overlap in part"));
    CHECK(contains(refusal_of(on(opcode, {0, 8}, {7, 8}, {20, 8})), "overlap in part"));
    CHECK(contains(refusal_of(on(opcode, {40, 8}, {0, 8}, {7, 8})), "overlap in part"));
    CHECK(contains(refusal_of(on(opcode, {40, 8}, {0, 8}, {20, 7})), "equally wide"));
  }
  CHECK(contains(refusal_of(on(Opcode::bit_not, {0, 8}, {1, 8})), "overlap in part"));
}

TEST_CASE("fields of other instructions must not overlap") {
  CHECK(refusal_of(on(Opcode::copy, {0, 8}, {8, 8})).empty());
  CHECK(contains(refusal_of(on(Opcode::copy, {0, 8}, {7, 8})), "overlap"));
  CHECK(contains(refusal_of(on(Opcode::field_lt, {0, 8}, {0, 8})), "overlap"));
  CHECK(contains(refusal_of(on(Opcode::copy, {5, 1}, {5, 1})), "overlap"));
}

TEST_CASE("operands of copy and comparisons must be equally wide") {
  for (const Opcode opcode : {Opcode::copy, Opcode::field_lt, Opcode::field_le, Opcode::field_eq, Opcode::bit_not}) {
    CHECK(refusal_of(on(opcode, {0, 7}, {8, 7})).empty());
    CHECK(contains(refusal_of(on(opcode, {0, 8}, {8, 7})), "equally wide"));
  }
}

TEST_CASE("an addend must be no wider than its target and must not overlap it") {
  CHECK(refusal_of(on(Opcode::add, {0, 8}, {8, 8})).empty());
  CHECK(refusal_of(on(Opcode::add, {40, 32}, {39, 1})).empty());
  CHECK(refusal_of(on(Opcode::add, {0, 8}, {20, 9})) ==
        "add: field [20+:9] is wider than field [0+:8]; make it at most as wide");
  CHECK(contains(refusal_of(on(Opcode::add, {0, 8}, {7, 1})), "overlap"));
  CHECK(contains(refusal_of(on(Opcode::add, {0, 8}, {0, 8})), "overlap"));
  CHECK(contains(refusal_of(on(Opcode::add, {0, 8})), "0 bits wide"));
  CHECK(contains(refusal_of(on(Opcode::add, {0, 8}, {71, 2})), "outside the 72 memory bits"));
  CHECK_FALSE(refusal_of(on(Opcode::add, {0, 8}, {8, 8}, {16, 8})).empty());
}

TEST_CASE("a stripe takes a linear expression and no field") {
  CHECK(refusal_of(streaming(Opcode::stripe, {}, 1)).empty());
  CHECK(refusal_of(streaming(Opcode::stripe, {}, 62, 61)).empty());
  CHECK(contains(refusal_of(streaming(Opcode::stripe, {}, 63)), "63 bits wide"));
  CHECK(contains(refusal_of(streaming(Opcode::stripe, {}, 12, 12)), "shift 12"));
  CHECK(contains(refusal_of(streaming(Opcode::stripe, {0, 1}, 12)), "not a field"));
}

TEST_CASE("a linear expression has 1 to 62 bits and keeps a bit after the shift") {
  CHECK(refusal_of(streaming(Opcode::edge_negative, {}, 1)).empty());
  CHECK(refusal_of(streaming(Opcode::edge_negative, {}, 62, 61)).empty());
  CHECK_FALSE(refusal_of(streaming(Opcode::edge_negative, {}, 0)).empty());
  CHECK_FALSE(refusal_of(streaming(Opcode::edge_negative, {}, 63)).empty());
  CHECK(contains(refusal_of(streaming(Opcode::edge_negative, {}, 12, 12)), "shift 12"));
}

TEST_CASE("F has one bit more than its field") {
  for (const Opcode opcode : {Opcode::linear_ge, Opcode::linear_eq, Opcode::load_linear, Opcode::keep_max}) {
    CHECK(refusal_of(streaming(opcode, {0, 20}, 33, 12)).empty());
    CHECK(contains(refusal_of(streaming(opcode, {0, 20}, 32, 12)), "at least one bit more than the field"));
  }
}

TEST_CASE("a constant must fit its target") {
  CHECK(refusal_of({Opcode::xor_constant, {{{3, 5}}}, {}, 31, {}}).empty());
  CHECK(contains(refusal_of({Opcode::xor_constant, {{{3, 5}}}, {}, 32, {}}), "does not fit 5 bits"));
  CHECK(refusal_of({Opcode::set_constant, {{{0, 8}}}, {}, 255, {}}).empty());
  CHECK(contains(refusal_of({Opcode::set_constant, {{{0, 8}}}, {}, 256, {}}), "does not fit 8 bits"));
  CHECK(refusal_of({Opcode::set_constant, {{{0, 32}}}, {}, 0xffffffffU, {}}).empty());
  CHECK_FALSE(refusal_of({Opcode::set_constant, {{{0, 32}}}, {}, 1ULL << 32U, {}}).empty());
}

TEST_CASE("a skip omits at least one instruction and stays in its segment") {
  const auto skip = [](std::uint64_t count) { return Instruction{Opcode::skip_if_none, {}, {}, count, {}}; };
  CHECK(refusal_of(skip(1)).empty());
  CHECK(refusal_of(skip(0)) == "skip_if_none 0 skips nothing; skip at least one instruction, or remove it");
  CHECK(refusal_of(skip(0xffffffffU)).empty());
  CHECK(contains(refusal_of(skip(0x100000000U)), "can skip at most 4294967295 instructions"));
  Program program = sample_program();
  std::vector<Instruction>& instructions = program.segments[0].instructions;
  const std::size_t last = instructions.size() - 1;
  instructions[0] = skip(last);
  CHECK(refusal_of(program).empty());
  for (const std::uint64_t count : {last + 1, std::size_t{0xffffffffU}}) {
    instructions[0] = skip(count);
    CHECK(refusal_of(program).starts_with("segment 0, instruction 0: skip_if_none " + std::to_string(count) +
                                          " skips past the end of the segment, which has " + std::to_string(last) +
                                          " more"));
  }
  instructions[0] = skip(1);
  instructions[last] = skip(1);
  program.segments[1].instructions = {skip(1), skip(1), instructions[1]};
  CHECK(refusal_of(program).starts_with("segment 0, instruction " + std::to_string(last) + ": "));
}

TEST_CASE("the error for an invalid Program names the segment and the instruction") {
  Program program = sample_program();
  program.segments[0].instructions[3].linear.width = 3;
  CHECK(refusal_of(program).starts_with("segment 0, instruction 3: linear_ge: "));
}

TEST_CASE("a linear expression must stay below 2^62 over its region") {
  Program program = sample_program();
  Linear& linear = program.segments[0].instructions[4].linear;
  const std::int64_t bound = std::int64_t{1} << 62U;
  linear = {0, 0, bound - 1, 62, 0};
  CHECK(refusal_of(program).empty());
  linear = {0, 0, -bound, 62, 0};
  CHECK(contains(refusal_of(program), "2^62"));
  linear = {bound / 7, 0, 0, 62, 0};
  CHECK(refusal_of(program).empty());
  linear = {bound / 7, 1, 0, 62, 0};
  CHECK_FALSE(refusal_of(program).empty());
  linear = {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min(), 0, 62, 0};
  CHECK_FALSE(refusal_of(program).empty());
}

TEST_CASE("origins must refer to primitives of the Program or to none") {
  Program program = sample_program();
  Origin& origin = program.segments[0].instructions[0].origin;
  origin = {Purpose::render, 1, 1};
  CHECK(refusal_of(program).empty());
  origin = {Purpose::render, 2, no_node};
  CHECK(contains(refusal_of(program), "p2"));
  origin = {Purpose::render, no_primitive, 2};
  CHECK(contains(refusal_of(program), "node"));
}

TEST_CASE("an array has sides of 1 to 16384 pixels and 1 to 4096 memory bits") {
  for (const ArrayShape shape :
       {ArrayShape{0, 4, 40}, {8, 0, 40}, {16385, 4, 40}, {8, 16385, 40}, {8, 4, 0}, {8, 4, 4097}}) {
    Program program;
    program.shape = shape;
    CHECK_FALSE(refusal_of(program).empty());
  }
  Program program;
  program.shape = {16384, 16384, 4096};
  CHECK(refusal_of(program).empty());
}

TEST_CASE("regions of a Program must not be empty and must lie in the picture") {
  for (const Region region : {Region{0, 0, 0, 1},
                              {0, 0, 1, 0},
                              {8, 0, 1, 1},
                              {1, 0, 8, 4},
                              {0, 1, 8, 4},
                              {0, 4, 1, 1},
                              {0xffffffffU, 0, 2, 1},
                              {1, 0, 0xffffffffU, 1}}) {
    Program program = sample_program();
    program.segments[1].region = region;
    CHECK(refusal_of(program).starts_with("segment 1: "));
  }
}

TEST_CASE("named fields of a Program must lie in the memory and have unique names") {
  Program program = sample_program();
  program.facts->fields[0].field = {33, 8};
  CHECK(refusal_of(program).starts_with("field 'Z1': "));
  program = sample_program();
  program.facts->fields[1].name = "Z1";
  CHECK(contains(refusal_of(program), "named twice"));
  program = sample_program();
  program.facts->fields[1].name.clear();
  CHECK(contains(refusal_of(program), "empty name"));
  program = sample_program();
  program.facts->fields[1].role = static_cast<FieldRole>(200);
  CHECK(contains(refusal_of(program), "role 200"));
}

TEST_CASE("depth limits of a Program must be finite and in perspective positive") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const DepthScale scale : {DepthScale{false, 1, 1},
                                 {false, 2, 1},
                                 {false, 0, infinity},
                                 {false, -infinity, 0},
                                 {false, std::nan(""), 1},
                                 {true, 0, 1},
                                 {true, -1, 1}}) {
    Program program = sample_program();
    program.facts->depth_scale = scale;
    CHECK_FALSE(refusal_of(program).empty());
  }
  Program program = sample_program();
  program.facts->depth_scale = {false, -1, 0};
  CHECK(refusal_of(program).empty());
}

}  // namespace
