#include "hw/scan_line/packet.h"

#include <algorithm>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t most_word_bits = 64;

std::uint64_t word_of(std::int64_t coefficient, std::uint32_t number, std::uint32_t word_bits) {
  const std::uint32_t low = number * word_bits;
  const auto shifted = static_cast<std::uint64_t>(coefficient >> std::min(low, most_word_bits - 1));
  return word_bits == most_word_bits ? shifted : shifted & ((std::uint64_t{1} << word_bits) - 1);
}

FieldWords words_of(isa::Field field, const CellShape& cell) {
  if (field.width == 0) return {};
  const auto first = static_cast<std::uint16_t>(field.base / cell.word_bits);
  return {field, first, static_cast<std::uint16_t>((field.end() - 1) / cell.word_bits - first + 1)};
}

Accesses accesses_of(const isa::Instruction& instruction, const CellShape& cell) {
  Accesses accesses;
  std::size_t sources = 0;
  const isa::Operands& operands = isa::operands_of(instruction.opcode);
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const bool target = operands[i] == isa::OperandKind::target;
    const FieldWords words = words_of(instruction.fields[i], cell);
    if (target) accesses.target = words;
    if (operands[i] == isa::OperandKind::source || (target && isa::reads_target(instruction.opcode)))
      accesses.sources.at(sources++) = words;
  }
  return accesses;
}

/// Clocks of a root's trials.
std::uint32_t trial_clocks(isa::Field field, const CellShape& cell) {
  std::uint32_t clocks = 0;
  for (std::uint32_t bit = 0; bit < field.width / 2U; ++bit) clocks += quotient_up(bit + 3, cell.word_bits);
  return clocks;
}

/// Finds out how long the packet occupies a cell.
void schedule(PacketWord& packet, const CellShape& cell) {
  Accesses& accesses = packet.accesses;
  const std::uint32_t read_words = std::uint32_t{accesses.sources[0].count} + accesses.sources[1].count;
  const std::uint32_t reads = cell.ports == 0 ? 0 : quotient_up(read_words, cell.ports);
  const std::uint32_t writes = cell.ports == 0 ? 0 : quotient_up(accesses.target.count, cell.ports);
  const std::uint32_t last_read = reads > 0 ? reads - 1 : 0;
  accesses.result = std::max(packet.words - 1, writes > 0 ? reads : last_read);
  if (packet.kind == WordKind::instruction && packet.instruction.opcode == isa::Opcode::root) {
    accesses.root_from = reads;
    accesses.result = reads + trial_clocks(accesses.target.field, cell) - 1;
  }
  packet.beats = accesses.result + std::max(writes, 1U);
}

void load_words(PacketWord& beat, const CellShape& cell) {
  const bool comes_in = beat.number < beat.words;
  const isa::Linear& linear = beat.instruction.linear;
  beat.f = comes_in ? word_of(linear.c, beat.number, cell.word_bits) : 0;
  beat.a = comes_in ? word_of(linear.a + beat.square, beat.number, cell.word_bits) : 0;
  beat.aa = comes_in ? word_of(2 * beat.square, beat.number, cell.word_bits) : 0;
}

}  // namespace

PacketWord instruction_packet(const isa::Instruction& instruction, const CellShape& cell, const isa::Linear& squares) {
  PacketWord packet{.kind = WordKind::instruction,
                    .square = squares.a,
                    .accesses = accesses_of(instruction, cell),
                    .instruction = instruction};
  if (instruction.opcode == isa::Opcode::squares) packet.instruction.linear = {};
  std::uint32_t bits = std::max<std::uint32_t>(packet.instruction.linear.width, 1);
  for (const isa::Field& field : instruction.fields) bits = std::max<std::uint32_t>(bits, field.width);
  packet.words = quotient_up(bits, cell.word_bits);
  schedule(packet, cell);
  load_words(packet, cell);
  return packet;
}

PacketWord clear_packet(std::uint32_t clocks) { return {.kind = WordKind::clear, .beats = clocks}; }

PacketWord mark_packet(isa::Field colour, const CellShape& cell) {
  PacketWord packet{.kind = WordKind::mark};
  packet.accesses.sources[0] = words_of(colour, cell);
  schedule(packet, cell);
  return packet;
}

PacketWord background_packet(isa::Field colour, std::uint32_t background, const CellShape& cell) {
  PacketWord packet{.kind = WordKind::mark, .background = true};
  packet.words = quotient_up(std::max<std::uint32_t>(colour.width, 1), cell.word_bits);
  packet.instruction.constant = background;
  schedule(packet, cell);
  return packet;
}

PacketWord next_beat(PacketWord beat, const CellShape& cell) {
  ++beat.number;
  load_words(beat, cell);
  return beat;
}

}  // namespace csgsim::scan_line
