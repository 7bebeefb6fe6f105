#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

namespace {

constexpr unsigned most_word_bits = 64;

std::uint64_t word_of(std::int64_t coefficient, unsigned number, unsigned word_bits) {
  const unsigned low = number * word_bits;
  const auto shifted = static_cast<std::uint64_t>(coefficient >> (low < most_word_bits ? low : most_word_bits - 1));
  return word_bits == most_word_bits ? shifted : shifted & ((std::uint64_t{1} << word_bits) - 1);
}

}  // namespace

PacketWord packet_word(const isa::Instruction& instruction, std::uint16_t number, std::uint32_t word_bits) {
  return {.kind = WordKind::instruction,
          .number = number,
          .a = word_of(instruction.linear.a, number, word_bits),
          .f = word_of(instruction.linear.c, number, word_bits),
          .instruction = instruction};
}

}  // namespace csgsim::scan_line
