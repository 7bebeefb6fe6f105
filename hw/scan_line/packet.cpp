#include "hw/scan_line/packet.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t max_word_bits = 64;

/// Wide enough for F in any cell: the words of a packet may have more than 64 bits in total.
__extension__ using Wide = __int128;

std::uint64_t word_of(Wide number, std::uint32_t place, std::uint32_t word_bits) {
  const auto shifted = static_cast<std::uint64_t>(number >> (place * word_bits));
  return shifted & ~std::uint64_t{0} >> (max_word_bits - word_bits);
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

/// What a cell does for an instruction.
struct CellFunctions {
  AluFunction alu = AluFunction::none;
  EnableFunction enable = EnableFunction::keep;
};

struct CellRow {
  isa::Opcode opcode;
  CellFunctions functions;
};

/// The instructions that need the ALU or change E.
constexpr auto cell_rows = [] {
  using isa::Opcode;
  using Alu = AluFunction;
  using Enable = EnableFunction;
  return std::to_array<CellRow>({
      {Opcode::enable_all, {Alu::none, Enable::set}},
      {Opcode::enable_invert, {Alu::none, Enable::invert}},
      {Opcode::enable_load, {Alu::none, Enable::load}},
      {Opcode::enable_and, {Alu::none, Enable::and_field}},
      {Opcode::enable_and_not, {Alu::none, Enable::and_not_field}},
      {Opcode::enable_or, {Alu::none, Enable::or_field}},
      {Opcode::enable_xor, {Alu::none, Enable::xor_field}},
      {Opcode::edge_not_negative, {Alu::none, Enable::where_not_negative}},
      {Opcode::edge_negative, {Alu::none, Enable::where_negative}},
      {Opcode::stripe, {Alu::none, Enable::where_negative}},
      {Opcode::linear_ge, {Alu::subtract, Enable::where_holds}},
      {Opcode::linear_gt, {Alu::subtract, Enable::where_holds}},
      {Opcode::linear_le, {Alu::subtract, Enable::where_holds}},
      {Opcode::linear_lt, {Alu::subtract, Enable::where_holds}},
      {Opcode::linear_eq, {Alu::subtract, Enable::where_holds}},
      {Opcode::field_lt, {Alu::subtract, Enable::where_holds}},
      {Opcode::field_le, {Alu::subtract, Enable::where_holds}},
      {Opcode::field_eq, {Alu::subtract, Enable::where_holds}},
      {Opcode::load_linear, {Alu::subtract, Enable::where_fits}},
      {Opcode::keep_max, {Alu::subtract, Enable::where_fits}},
      {Opcode::keep_min, {Alu::subtract, Enable::where_fits}},
      {Opcode::linear_minus, {.alu = Alu::subtract}},
      {Opcode::linear_plus, {.alu = Alu::add}},
      {Opcode::add, {.alu = Alu::add}},
      {Opcode::bit_and, {.alu = Alu::bit_and}},
      {Opcode::bit_or, {.alu = Alu::bit_or}},
      {Opcode::bit_xor, {.alu = Alu::bit_xor}},
      {Opcode::xor_constant, {.alu = Alu::bit_xor}},
      {Opcode::bit_and_not, {.alu = Alu::bit_and_not}},
      {Opcode::bit_not, {.alu = Alu::bit_not}},
  });
}();

/// By number of the opcode.
constexpr auto cell_functions = [] {
  std::array<CellFunctions, isa::opcode_numbers> functions{};
  for (const CellRow& row : cell_rows) functions.at(static_cast<std::size_t>(row.opcode)) = row.functions;
  return functions;
}();

constexpr const CellFunctions& functions_of(isa::Opcode opcode) {
  return cell_functions[static_cast<std::size_t>(opcode)];
}

static_assert(
    [] {
      for (const isa::OpcodeInfo& row : isa::opcode_table) {
        const bool keeps = functions_of(row.opcode).enable == EnableFunction::keep;
        if (keeps != (row.enable_effect == isa::EnableEffect::keeps)) return false;
      }
      return true;
    }(),
    "the functions of E agree with the table of the instruction set");

/// Aligns an operand of `bits` bits, which begins at bit `begins` of a word, with the field's position in its word.
Move move_to(isa::Field field, std::uint32_t begins, std::uint32_t bits, const CellShape& cell) {
  const std::uint32_t required = field.base % cell.word_bits;
  return {quotient_up(required + bits, cell.word_bits), begins > required ? begins - required : required - begins};
}

/// Operands are aligned with the first field, which is the target if there is one. F is sign-extended as far as it is
/// used; constants, and single bits combined with E, need no alignment.
CellWork work_of(const isa::Instruction& instruction, const CellShape& cell) {
  CellWork work{.function = functions_of(instruction.opcode).alu};
  const isa::Field& place = instruction.fields[0];
  const isa::Operands& operands = isa::operands_of(instruction.opcode);
  const bool is_linear = isa::has_operand(operands, isa::OperandKind::linear) && place.width > 0;
  const std::uint32_t f_bits = is_linear ? std::uint32_t{instruction.linear.width} - instruction.linear.shift : 0;
  const bool sums = instruction.opcode == isa::Opcode::linear_plus || instruction.opcode == isa::Opcode::linear_minus;
  std::size_t moves = 0;
  if (is_linear) {
    const std::uint32_t required = sums ? std::min<std::uint32_t>(f_bits, place.width) : f_bits;
    work.moves.at(moves++) = move_to(place, instruction.linear.shift % cell.word_bits, required, cell);
  }
  for (std::size_t i = 1; i < operands.size(); ++i) {
    const isa::Field& field = instruction.fields[i];
    if (field.width > 0) work.moves.at(moves++) = move_to(place, field.base % cell.word_bits, field.width, cell);
  }
  if (work.function != AluFunction::none) work.bits = is_linear && !sums ? f_bits : place.width;
  return work;
}

/// Clocks of an alignment, found by simulating its steps.
std::uint32_t clocks_of(const Move& move, const CellShape& cell) {
  std::uint32_t clocks = 0;
  for (std::uint32_t moved = 0; cell.shift_bits > 0 && moved < move.distance; moved += cell.shift_bits)
    clocks += move.words;
  return clocks;
}

std::uint32_t alu_clocks(std::uint32_t bits, std::uint32_t bits_a_clock) {
  std::uint32_t clocks = 0;
  for (std::uint32_t done = 0; done < bits; done += bits_a_clock) ++clocks;
  return clocks;
}

std::uint32_t clocks_of(const CellWork& work, const CellShape& cell) {
  std::uint32_t clocks = alu_clocks(work.bits, alu_width(cell, work.bits));
  for (const Move& move : work.moves) clocks += clocks_of(move, cell);
  return clocks;
}

/// Clocks of a root's trials.
std::uint32_t trial_clocks(isa::Field field, const CellShape& cell) {
  std::uint32_t clocks = 0;
  for (std::uint32_t bit = 0; bit < field.width / 2U; ++bit)
    clocks += alu_clocks(bit + 3, alu_width(cell, cell.word_bits));
  return clocks;
}

/// Computes how long the packet occupies a cell.
void schedule(Packet& packet, const CellShape& cell) {
  Accesses& accesses = packet.accesses;
  const std::uint32_t read_words = std::uint32_t{accesses.sources[0].count} + accesses.sources[1].count;
  const std::uint32_t reads = cell.ports == 0 ? 0 : quotient_up(read_words, cell.ports);
  const std::uint32_t writes = cell.ports == 0 ? 0 : quotient_up(accesses.target.count, cell.ports);
  if (packet.kind == PacketKind::instruction && packet.instruction.opcode == isa::Opcode::root) {
    accesses.work_from = reads;
    accesses.result = reads + trial_clocks(accesses.target.field, cell) - 1;
  } else {
    const std::uint32_t last_read = reads > 0 ? reads - 1 : 0;
    accesses.work_from = std::max(packet.words - 1, last_read);
    const std::uint32_t last_work = accesses.work_from + std::max(clocks_of(packet.work, cell), 1U) - 1;
    accesses.result = std::max(last_work, writes > 0 ? reads : 0);
  }
  packet.beats = accesses.result + std::max(writes, 1U);
}

}  // namespace

EnableFunction enable_function_of(isa::Opcode opcode) { return functions_of(opcode).enable; }

Packet instruction_packet(const isa::Instruction& instruction, const CellShape& cell, const isa::Linear& squares) {
  Packet packet{.kind = PacketKind::instruction,
                .square = squares.a,
                .accesses = accesses_of(instruction, cell),
                .work = work_of(instruction, cell),
                .instruction = instruction};
  if (instruction.opcode == isa::Opcode::squares) packet.instruction.linear = {};
  packet.words = quotient_up(std::max<std::uint32_t>(packet.instruction.linear.width, 1), f_bits(cell));
  for (const isa::Field& field : instruction.fields)
    packet.words = std::max<std::uint32_t>(packet.words, quotient_up(field.width, cell.word_bits));
  schedule(packet, cell);
  return packet;
}

Packet clear_packet(std::uint32_t clocks) { return {.kind = PacketKind::clear, .beats = clocks}; }

Packet mark_packet(isa::Field colour, const CellShape& cell) {
  Packet packet{.kind = PacketKind::mark};
  packet.accesses.sources[0] = words_of(colour, cell);
  schedule(packet, cell);
  return packet;
}

Packet background_packet(isa::Field colour, std::uint32_t background, const CellShape& cell) {
  Packet packet{.kind = PacketKind::mark, .background = true};
  packet.words = quotient_up(std::max<std::uint32_t>(colour.width, 1), cell.word_bits);
  packet.instruction.constant = background;
  schedule(packet, cell);
  return packet;
}

BeatWords arriving_words(const Beat& beat, std::uint32_t cell_index, const CellShape& cell) {
  if (beat.number >= beat.packet->words) return {};
  const isa::Linear& linear = beat.packet->instruction.linear;
  const auto word = [&](Wide number) { return word_of(number, beat.number, f_bits(cell)); };
  const Wide square = beat.packet->square;
  return {.f = word((square * cell_index + linear.a) * cell_index + linear.c),
          .a = word(square * (2 * Wide{cell_index} + 1) + linear.a),
          .aa = word(2 * square)};
}

std::uint64_t received_sum(const Packet& packet, std::uint32_t beat_count, std::uint32_t cell_index,
                           const CellShape& cell) {
  const isa::Linear& linear = packet.instruction.linear;
  const auto sum = static_cast<std::uint64_t>((packet.square * Wide{cell_index} + linear.a) * cell_index + linear.c);
  const std::uint64_t bits = std::uint64_t{std::min(beat_count, packet.words)} * f_bits(cell);
  if (bits == 0) return 0;
  return bits < max_word_bits ? sum & ((std::uint64_t{1} << bits) - 1) : sum;
}

}  // namespace csgsim::scan_line
