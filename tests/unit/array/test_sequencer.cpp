#include <rapidcheck.h>

#include "hw/array/sequencer.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/kind.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

namespace {

using csgsim::array::AluFunction;
using csgsim::array::ArrayStep;
using csgsim::array::BitStep;
using csgsim::array::RootBits;
using csgsim::array::Sequencer;
namespace isa = csgsim::isa;

csgsim::machines::Machine machine_with(std::uint32_t reads, std::uint32_t alu_bits, std::uint32_t tree_bits) {
  csgsim::machines::Machine machine = csgsim::machines::blank_machine(csgsim::pixel_planes::kind);
  machine.array = {1, 1, 64};  // no latency: a query takes one clock, as its step does
  machine.memory_reads = reads;
  machine.alu_bits = alu_bits;
  machine.evaluator_bits = tree_bits;
  return machine;
}

struct Hardware {
  std::uint32_t reads;  ///< ports of pixel memory
  std::uint32_t alu_bits;
  std::uint32_t tree_bits;  ///< bits per clock from the trees
};
constexpr Hardware hardware[] = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 3, 3},  {1, 4, 2},  {2, 4, 3},
                                 {1, 8, 1}, {2, 8, 7}, {1, 8, 8}, {1, 32, 5}, {2, 32, 32}};

/// Work done with one bit of a stream.
struct BitWork {
  int bit = 0;  ///< index in the stream
  AluFunction function = AluFunction::idle;
  unsigned y = 0;  ///< memory address
  unsigned write = 0;

  bool operator==(const BitWork&) const = default;
};

/// Work for each bit of F that causes any.
std::vector<BitWork> bits_of(Sequencer sequencer, const isa::Instruction& instruction) {
  std::vector<BitWork> all;
  sequencer.begin(instruction);
  while (sequencer.busy()) {
    const BitStep step = sequencer.issue();
    const ArrayStep& pixels = step.pixels;
    RC_ASSERT(pixels.function == AluFunction::idle ||
              pixels.first + processed_bits(pixels) <= unsigned{step.root.token.bits});
    for (unsigned bit = 0; bit < processed_bits(pixels); ++bit) {
      const AluFunction function = function_of_bit(pixels, bit);
      if (function == AluFunction::idle) continue;
      const bool reads = info(function).reads_y;
      const bool writes = info(function).writes;
      all.push_back({step.root.token.bit + pixels.first + static_cast<int>(bit), function, reads ? pixels.y + bit : 0,
                     writes ? pixels.write + bit : 0});
    }
  }
  return all;
}

isa::Instruction some_instruction() { return *csgsim::test::arbitrary_instruction({8, 8, 64}, 64, 1); }

}  // namespace

TEST_CASE("an instruction has one bit step per clock of the table and marks only the last") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    CHECK(rc::check([reads = reads, alu_bits = alu_bits, tree_bits = tree_bits] {
      const isa::Instruction instruction = some_instruction();
      Sequencer sequencer(reads, alu_bits, tree_bits);
      sequencer.begin(instruction);
      std::uint64_t steps = 0;
      while (sequencer.busy()) {
        ++steps;
        const bool last = sequencer.issue().last;
        RC_ASSERT(last == !sequencer.busy());
      }
      RC_ASSERT(steps == csgsim::machines::clocks(instruction, machine_with(reads, alu_bits, tree_bits)));
    }));
  }
}

TEST_CASE("no bit step reads pixel memory more often than it has ports") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    CHECK(rc::check([reads = reads, alu_bits = alu_bits, tree_bits = tree_bits] {
      Sequencer sequencer(reads, alu_bits, tree_bits);
      sequencer.begin(some_instruction());
      while (sequencer.busy()) RC_ASSERT(memory_reads(sequencer.issue().pixels) <= reads);
    }));
  }
}

TEST_CASE("coefficients are sent in two's complement from the least significant bit") {
  Sequencer sequencer(1, 1, 1);
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

TEST_CASE("trees of several bits receive full groups of bits and the remainder last") {
  Sequencer sequencer(1, 8, 3);
  // -2 is 1110 in four bits, 5 is 0101 and 1 is 0001.
  sequencer.begin({.opcode = isa::Opcode::edge_negative, .linear = {.a = -2, .b = 5, .c = 1, .width = 4}});
  const BitStep first = sequencer.issue();
  CHECK(first.root == RootBits{.token = {.bit = 0, .bits = 3}, .a = 0b110, .b = 0b101, .c = 0b001});
  CHECK(first.pixels == ArrayStep{});
  const BitStep second = sequencer.issue();
  CHECK(second.root == RootBits{.token = {.bit = 3, .bits = 1}, .a = 1, .b = 0, .c = 0});
  CHECK(second.pixels == ArrayStep{.function = AluFunction::enable_and});
  CHECK(second.last);
}

TEST_CASE("pixels process each bit of F in the clock in which it arrives") {
  // Bits 0 to 2 of F are its fraction, bits 3 to 6 align with the field, bits 7 to 10 are beyond it, and bit 11 is the
  // sign.
  const isa::Instruction instruction{
      .opcode = isa::Opcode::linear_ge, .fields = {isa::Field{20, 4}}, .linear = {1, 1, 1, 12, 3}};
  using enum AluFunction;
  const auto steps = [&](std::uint32_t tree_bits) {
    Sequencer sequencer(1, 32, tree_bits);
    sequencer.begin(instruction);
    std::vector<ArrayStep> all;
    while (sequencer.busy()) all.push_back(sequencer.issue().pixels);
    return all;
  };
  CHECK(steps(5) ==
        std::vector<ArrayStep>{{.function = compare_from_1, .y = 20, .bits = 2, .first = 3},
                               {.function = compare, .y = 22, .bits = 2, .beyond_bits = 3, .beyond = compare_with_0},
                               {.function = compare_with_0, .bits = 1, .sign = sign_enable}});
  CHECK(steps(3) == std::vector<ArrayStep>{{},
                                           {.function = compare_from_1, .y = 20, .bits = 3},
                                           {.function = compare, .y = 23, .beyond_bits = 2, .beyond = compare_with_0},
                                           {.function = compare_with_0, .bits = 2, .sign = sign_enable}});
  for (const std::uint32_t all : {12U, 13U, 32U})
    CHECK(steps(all) == std::vector<ArrayStep>{{.function = compare_from_1,
                                                .y = 20,
                                                .bits = 4,
                                                .first = 3,
                                                .beyond_bits = 4,
                                                .beyond = compare_with_0,
                                                .sign = sign_enable}});
}

TEST_CASE("each bit of F has the same ALU function and address for any tree width") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    CHECK(rc::check([reads = reads, alu_bits = alu_bits, tree_bits = tree_bits] {
      const isa::Instruction instruction = some_instruction();
      RC_PRE(isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear));
      RC_ASSERT(bits_of(Sequencer(reads, alu_bits, tree_bits), instruction) ==
                bits_of(Sequencer(reads, 1, 1), instruction));
    }));
  }
}

TEST_CASE("with one read port the first source is latched a clock before the second is read") {
  Sequencer sequencer(1, 1, 1);
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

TEST_CASE("every opcode with fields of every width takes the clocks of the table") {
  for (const auto& [reads, bits, brought] : hardware) {
    const std::uint32_t alu_bits = bits;  // copies, because CAPTURE cannot use structured bindings
    const std::uint32_t tree_bits = brought;
    for (const isa::OpcodeInfo& row : isa::opcode_table) {
      for (std::uint16_t width = 1; width <= isa::max_field_width; ++width) {
        isa::Instruction instruction{.opcode = row.opcode};
        for (unsigned i = 0; i < isa::max_operands; ++i) {
          if (isa::is_field(row.operands[i])) {
            instruction.fields[i] = {static_cast<std::uint16_t>(i * isa::max_field_width), width};
          }
        }
        const bool single = row.widths == isa::FieldWidths::one;
        if (single && width > 1) continue;
        if (row.widths == isa::FieldWidths::odd && (width < 3 || width % 2 == 0)) continue;
        if (isa::has_operand(row.operands, isa::OperandKind::linear)) {
          instruction.linear = {1, 1, 1, static_cast<std::uint16_t>(width + 3), 2};
        }
        Sequencer sequencer(reads, alu_bits, tree_bits);
        sequencer.begin(instruction);
        std::uint64_t steps = 0;
        for (; sequencer.busy(); ++steps) sequencer.issue();
        CAPTURE(std::string(row.name));
        CAPTURE(width);
        CAPTURE(alu_bits);
        CAPTURE(tree_bits);
        CHECK(steps == csgsim::machines::clocks(instruction, machine_with(reads, alu_bits, tree_bits)));
      }
    }
  }
}

TEST_CASE("a root of w bits takes w(w + 2) clocks or w(w + 5) / 2 with two read ports") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    for (std::uint16_t bits = 1; bits <= 30; ++bits) {
      Sequencer sequencer(reads, alu_bits, tree_bits);
      sequencer.begin(
          {.opcode = isa::Opcode::root, .fields = {isa::Field{2, static_cast<std::uint16_t>(2 * bits + 1)}}});
      unsigned clocks = 0;
      unsigned top = 2U + 2U * bits;  // address of the next bit of the root
      for (; sequencer.busy(); ++clocks) {
        const csgsim::array::ArrayStep step = sequencer.issue().pixels;
        CHECK(memory_reads(step) <= reads);
        CHECK(step.bits == 1);
        if (step.function != AluFunction::root_first && step.function != AluFunction::root_sign) continue;
        CHECK(step.write == top--);
      }
      CHECK(top == 2U + bits);
      CHECK(clocks == (reads == 1 ? bits * bits + 2U * bits : (bits * bits + 5U * bits) / 2));
    }
  }
}

TEST_CASE("squares take an idle clock and accompany only the next stream") {
  Sequencer sequencer(1, 1, 1);
  sequencer.begin({.opcode = isa::Opcode::squares, .linear = {.a = 1, .b = -2, .c = 4, .width = 4}});
  const BitStep rest = sequencer.issue();
  CHECK(rest.last);
  CHECK(rest.pixels == csgsim::array::ArrayStep{});
  CHECK_FALSE(rest.root.token.active());
  CHECK_FALSE(sequencer.busy());
  for (const bool has_squares : {true, false}) {
    sequencer.begin({.opcode = isa::Opcode::edge_negative, .linear = {.a = 7, .b = 1, .c = -8, .width = 4}});
    for (int bit = 0; bit < 4; ++bit) {
      const csgsim::array::RootBits root = sequencer.issue().root;
      CHECK(root.token.bit == bit);
      CHECK(root.a == (bit < 3));
      CHECK(root.b == (bit == 0));
      CHECK(root.c == (bit == 3));
      CHECK(root.xx == (has_squares && bit == 0));
      CHECK(root.xy == (has_squares && bit >= 1));
      CHECK(root.yy == (has_squares && bit == 2));
    }
    CHECK_FALSE(sequencer.busy());
  }
}

TEST_CASE("a constant's steps write each bit of the field once and in order") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    constexpr std::uint64_t constant = 0xb3a5;
    for (const isa::Opcode opcode : {isa::Opcode::set_constant, isa::Opcode::xor_constant}) {
      Sequencer sequencer(reads, alu_bits, tree_bits);
      sequencer.begin({.opcode = opcode, .fields = {isa::Field{7, 17}}, .constant = constant});
      std::uint64_t written = 0;
      unsigned next = 7;
      while (sequencer.busy()) {
        const csgsim::array::ArrayStep step = sequencer.issue().pixels;
        CHECK(step.write == next);
        CHECK(step.bits <= alu_bits);
        written |= std::uint64_t{step.constant} << (next - 7);
        next += step.bits;
      }
      CHECK(next == 7 + 17);
      CHECK(written == constant);
    }
  }
}

TEST_CASE("a comparison sets its carry at the first bit and changes E at the last") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    Sequencer sequencer(reads, alu_bits, tree_bits);
    sequencer.begin({.opcode = isa::Opcode::field_lt, .fields = {isa::Field{0, 9}, isa::Field{9, 9}}});
    std::vector<AluFunction> functions;
    while (sequencer.busy()) {
      const csgsim::array::ArrayStep step = sequencer.issue().pixels;
      if (step.function == AluFunction::latch_x) continue;
      for (unsigned bit = 0; bit < step.bits; ++bit) functions.push_back(function_of_bit(step, bit));
    }
    std::vector<AluFunction> expected(9, AluFunction::compare);
    expected.front() = AluFunction::compare_from_1;
    expected.back() = AluFunction::less;
    CHECK(functions == expected);
  }
}

TEST_CASE("a sum carries through its target and reads only existing bits of its source") {
  for (const auto& [reads, alu_bits, tree_bits] : hardware) {
    Sequencer sequencer(reads, alu_bits, tree_bits);
    sequencer.begin({.opcode = isa::Opcode::add, .fields = {isa::Field{3, 9}, isa::Field{59, 5}}});
    std::vector<AluFunction> functions;
    unsigned next = 59;  // next bit of the source; the last bit of memory is 63
    while (sequencer.busy()) {
      const csgsim::array::ArrayStep step = sequencer.issue().pixels;
      if (step.source == csgsim::array::OperandSource::memory && info(step.function).reads_x) {
        CHECK(step.x == next);
        for (unsigned bit = 0; bit < step.bits; ++bit)
          if (info(function_of_bit(step, bit)).reads_x) ++next;
      }
      if (!info(step.function).writes) continue;
      CHECK(step.write == 3 + functions.size());
      CHECK(step.y == step.write);
      for (unsigned bit = 0; bit < step.bits; ++bit) functions.push_back(function_of_bit(step, bit));
    }
    CHECK(next == 64);
    std::vector<AluFunction> expected(9, AluFunction::sum);
    expected.front() = AluFunction::sum_from_0;
    std::fill(expected.begin() + 5, expected.end(), AluFunction::sum_with_0);
    CHECK(functions == expected);
  }
}
