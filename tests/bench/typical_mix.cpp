#include "tests/bench/typical_mix.h"

#include "hw/isa/opcodes.h"

namespace csgsim::bench {

namespace {

using isa::Field;
using isa::Instruction;
using isa::Opcode;

constexpr unsigned fraction_bits = 12;
constexpr std::uint16_t linear_width = 34;
constexpr Field z1{0, 20};
constexpr Field z2{20, 20};
constexpr Field colour{40, 24};
constexpr Field in{64, 1};
constexpr Field left{65, 1};
constexpr Field visible{66, 1};

/// A plane whose depth changes by at most the full range over the array; `k` varies it.
isa::Linear plane(isa::ArrayShape shape, unsigned k) {
  const std::int64_t range = std::int64_t{1} << (z1.width - 2 + fraction_bits);
  const auto slope = [&](std::uint32_t side, unsigned seed) {
    return range / side * (static_cast<std::int64_t>(seed % 7) - 3) / 4;
  };
  return {.a = slope(shape.width, k),
          .b = slope(shape.height, k / 2 + 1),
          .c = range + static_cast<std::int64_t>(k % 11) * (range / 16),
          .width = linear_width,
          .shift = fraction_bits};
}

Instruction linear(Opcode opcode, Field field, isa::Linear expression) {
  return {.opcode = opcode, .fields = {field}, .linear = expression};
}

Instruction fields(Opcode opcode, Field first = {}, Field second = {}, Field third = {}) {
  return {.opcode = opcode, .fields = {first, second, third}};
}

void edges(std::vector<Instruction>& program, isa::ArrayShape shape, unsigned k) {
  for (unsigned edge = 0; edge < 4; ++edge) {
    isa::Linear expression = plane(shape, k + edge);
    expression.c = expression.a * -static_cast<std::int64_t>(shape.width / 8) + (std::int64_t{1} << 24U);
    program.push_back(linear(Opcode::edge_not_negative, {}, expression));
  }
}

void primitive(std::vector<Instruction>& program, isa::ArrayShape shape, unsigned k) {
  const auto add = [&](const Instruction& instruction) { program.push_back(instruction); };
  add(fields(Opcode::enable_all));
  add({.opcode = Opcode::set_constant, .fields = {z1}, .constant = 0});
  for (unsigned face = 0; face < 3; ++face) add(linear(Opcode::keep_max, z1, plane(shape, k + face)));
  edges(program, shape, k);
  for (unsigned face = 3; face < 6; ++face) add(linear(Opcode::linear_gt, z1, plane(shape, k + face)));
  add(fields(Opcode::enable_store, in));
  for (unsigned face = 6; face < 9; ++face) add(linear(Opcode::linear_le, z1, plane(shape, k + face)));
  add(fields(Opcode::enable_store, left));
  add(fields(Opcode::enable_load, in));
  add(fields(Opcode::bit_and_not, visible, in, left));
  add(fields(Opcode::enable_and, visible));
  add(fields(Opcode::field_lt, z1, z2));
  add(fields(Opcode::copy, z2, z1));
  add({.opcode = Opcode::set_constant, .fields = {colour}, .constant = 0x123456U + k});
}

}  // namespace

isa::Program typical_mix(isa::ArrayShape shape, unsigned primitives) {
  isa::Program program;
  program.shape = shape;
  isa::Segment& segment = program.segments.emplace_back();
  segment.region = {0, 0, shape.width, shape.height};
  segment.instructions.push_back(fields(Opcode::enable_all));
  segment.instructions.push_back({.opcode = Opcode::set_constant, .fields = {z2}, .constant = 0xfffffU});
  for (unsigned k = 0; k < primitives; ++k) primitive(segment.instructions, shape, k);
  return program;
}

}  // namespace csgsim::bench
