#pragma once

#include <array>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "hw/scan_line/figures.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::scan_line {

using systemc::Keep;

/// What a cell is built of.
struct CellShape {
  std::uint32_t word_bits = 1;   ///< of a word of memory, and of the adder of the running sum: 1 to 64
  std::uint32_t ports = 0;       ///< words of memory that are read or written in a clock; 0 for any number
  std::uint32_t alu_bits = 0;    ///< that the ALU goes through in a clock, of a word at most; 0 for any number
  std::uint32_t shift_bits = 0;  ///< by which the shifter moves a word in a clock; 0 if all lie where they are wanted
  std::uint32_t tree_bits = 0;   ///< of F that a tree brings in a clock, a word at most; 0 without trees: a word

  constexpr bool operator==(const CellShape&) const = default;
};

constexpr CellShape cell_shape(const Figures& figures) {
  return {.word_bits = figures.word_bits,
          .ports = figures.ports,
          .alu_bits = figures.alu_bits,
          .shift_bits = figures.shift_bits,
          .tree_bits = figures.network == Network::trees ? figures.tree_bits : 0};
}

/// Bits of F that come in with a beat.
constexpr std::uint32_t f_bits(const CellShape& cell) {
  return cell.tree_bits == 0 || cell.tree_bits > cell.word_bits ? cell.word_bits : cell.tree_bits;
}

enum class PacketKind : std::uint8_t {
  none,
  clear,        ///< the beginning of a line: memory and enable become 0
  instruction,  ///< an instruction's packet
  mark,         ///< the end of a line: each cell holds its colour for the refresh
};

/// A field and the words of a cell's memory that it lies in.
struct FieldWords {
  isa::Field field{};
  std::uint16_t first = 0;
  std::uint16_t count = 0;

  constexpr bool operator==(const FieldWords&) const = default;
};

/// What a packet asks of a cell's memory. Reads begin with the packet's first word, at each port one a clock. In the
/// first clock in which all words of the packet are there and the last read is done the cell's work begins. The clock
/// of the result is the last of the work, or, if something is to be written, the first after it or then in which the
/// ports are free again; the writes begin in it. The work of a root are its trials, which begin when the ports are
/// free: its bit of number k takes as many clocks as the ALU takes for a sum of k + 3 bits.
struct Accesses {
  std::array<FieldWords, 2> sources{};  ///< read one after the other
  FieldWords target{};                  ///< written
  std::uint32_t work_from = 0;          ///< clock, counted from the packet's first word in the cell
  std::uint32_t result = 0;             ///< likewise

  constexpr bool operator==(const Accesses&) const = default;
};

/// An operand that the shifter moves to where the other one, or the target, lies in its words: word after word, each by
/// the distance, in either direction; the bits that come in at its end are those of the word beside it.
struct Move {
  std::uint32_t words = 0;     ///< that it has where it comes to lie
  std::uint32_t distance = 0;  ///< bits, fewer than a word has

  constexpr bool operator==(const Move&) const = default;
};

/// What the ALU makes of two operands, x and y.
enum class AluFunction : std::uint8_t { none, add, subtract, bit_and, bit_or, bit_xor, bit_and_not, bit_not };

/// What a cell does with a packet's operands when all are there, one thing a clock: the shifter moves what lies
/// elsewhere, then the ALU goes through the operands from the lowest bits on. What follows from the sign of F, or from
/// a single bit and E, is no work.
struct CellWork {
  std::array<Move, 2> moves{};
  AluFunction function = AluFunction::none;
  std::uint32_t bits = 0;  ///< that the ALU goes through

  constexpr bool operator==(const CellWork&) const = default;
};

/// What moves from cell to cell, or from level to level of a tree, a beat a clock. It occupies each cell for `beats`
/// clocks: in the first `words` of them a word of F and of its difference to the next cell comes in, the least
/// significant first, and with squares one of the second difference; then the cell goes on with what it has.
struct Packet {
  PacketKind kind = PacketKind::none;
  bool begins_line = false;   ///< clears the cell's memory and enable before the cell acts
  bool background = false;    ///< a mark for a line that shows the constant
  Keep keep = Keep::nothing;  ///< what to take down of the cells as the packet leaves them, for who watches the run
  std::uint32_t words = 1;
  std::uint32_t beats = 1;
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< of the instruction in the segment
  std::int64_t square = 0;  ///< factor of x*x in F
  Accesses accesses{};
  CellWork work{};
  isa::Instruction instruction{};  ///< of a mark with a background: only the constant

  /// Words of F come with it.
  [[nodiscard]] constexpr bool brings_f() const {
    return kind == PacketKind::instruction && instruction.linear.width > 0;
  }
  constexpr bool operator==(const Packet&) const = default;
};

/// What is in a cell, or on its way to one, in a clock.
struct Beat {
  const Packet* packet = nullptr;  ///< which lives until the clock is over; null for nothing
  std::uint32_t number = 0;        ///< of the beat in it

  [[nodiscard]] constexpr bool last() const { return number + 1 == packet->beats; }
  constexpr bool operator==(const Beat&) const = default;
};

/// The words that come into a cell of a chain with a beat.
struct BeatWords {
  std::uint64_t f = 0;   ///< of F in that cell
  std::uint64_t a = 0;   ///< of F's difference to the next cell: without squares A
  std::uint64_t aa = 0;  ///< of the second difference

  constexpr bool operator==(const BeatWords&) const = default;
};

/// What comes out of a chain's refresh port in a clock.
struct RefreshPixel {
  bool valid = false;
  std::uint32_t colour = 0;

  constexpr bool operator==(const RefreshPixel&) const = default;
};

/// The packet of an instruction. `squares`: those of the instruction before. As a line is one row, number 0, only their
/// factor of x*x counts. Of an instruction `squares` itself the cells get nothing.
Packet instruction_packet(const isa::Instruction& instruction, const CellShape& cell, const isa::Linear& squares = {});
Packet clear_packet(std::uint32_t clocks);
Packet mark_packet(isa::Field colour, const CellShape& cell);
/// For a line that shows the background, in a field as wide as `colour`.
Packet background_packet(isa::Field colour, std::uint32_t background, const CellShape& cell);

/// What the adders of the cells before have made of C, A and the second difference when the beat is in cell `x`.
BeatWords words_in(const Beat& beat, std::uint32_t x, const CellShape& cell);

/// The low 64 bits of C + A*x + S*x*x, of those that have come to cell `x` with the first `beats` beats of a packet
/// that brings F.
std::uint64_t sum_in(const Packet& packet, std::uint32_t beats, std::uint32_t x, const CellShape& cell);

/// Bits that the ALU goes through in a clock; of an ideal one `bits`.
constexpr std::uint32_t alu_width(const CellShape& cell, std::uint32_t bits) {
  if (cell.alu_bits == 0) return bits;
  return cell.alu_bits < cell.word_bits ? cell.alu_bits : cell.word_bits;
}

}  // namespace csgsim::scan_line
