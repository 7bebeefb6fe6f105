#pragma once

#include <array>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "hw/scan_line/figures.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::scan_line {

using systemc::Keep;

/// Parameters of a cell.
struct CellShape {
  std::uint32_t word_bits = 1;   ///< bits of a word of memory and of the adder of the running sum, 1 to 64
  std::uint32_t ports = 0;       ///< words of memory read or written per clock; 0 for any number
  std::uint32_t alu_bits = 0;    ///< bits that the ALU processes per clock, at most a word; 0 for any number
  std::uint32_t shift_bits = 0;  ///< bits by which the shifter moves a word per clock; 0 if shifts take no clocks
  /// Bits of F that a tree delivers per clock, at most a word; 0 for a chain, which delivers one word.
  std::uint32_t tree_bits = 0;

  constexpr bool operator==(const CellShape&) const = default;
};

constexpr CellShape cell_shape(const Figures& figures) {
  return {.word_bits = figures.word_bits,
          .ports = figures.ports,
          .alu_bits = figures.alu_bits,
          .shift_bits = figures.shift_bits,
          .tree_bits = figures.network == Network::trees ? figures.tree_bits : 0};
}

/// Bits of F that arrive with a beat.
constexpr std::uint32_t f_bits(const CellShape& cell) {
  return cell.tree_bits == 0 || cell.tree_bits > cell.word_bits ? cell.word_bits : cell.tree_bits;
}

enum class PacketKind : std::uint8_t {
  none,
  clear,        ///< start of a line: memory and enable become 0
  instruction,  ///< an instruction's packet
  mark,         ///< end of a line: each cell holds its colour for the refresh
};

/// A field and the memory words of a cell that contain it.
struct FieldWords {
  isa::Field field{};
  std::uint16_t first = 0;
  std::uint16_t count = 0;

  constexpr bool operator==(const FieldWords&) const = default;
};

/// Schedule of a packet's memory accesses in a cell. Reads start with the packet's first word, one word per port and
/// clock. The cell's work starts in the first clock in which all words of the packet have arrived and all reads are
/// done. The result is available in the last clock of the work; if a target is written, not before the first clock in
/// which the ports are free, and the writes start in that clock. The work of a root consists of its trials, which start
/// when the ports are free: bit k takes the ALU's clocks for a sum of k + 3 bits.
struct Accesses {
  std::array<FieldWords, 2> sources{};  ///< read one after the other
  FieldWords target{};                  ///< written
  std::uint32_t work_from = 0;          ///< clock in which work starts, relative to the packet's first word in the cell
  std::uint32_t result = 0;             ///< clock of the result, relative to the same word

  constexpr bool operator==(const Accesses&) const = default;
};

/// Alignment of an operand with the other operand or the target: the shifter moves it word by word, each word by the
/// same distance, in either direction; bits shifted in come from the adjacent word.
struct Move {
  std::uint32_t words = 0;     ///< words of the operand after alignment
  std::uint32_t distance = 0;  ///< distance in bits, less than a word

  constexpr bool operator==(const Move&) const = default;
};

/// Function of the ALU on two operands, x and y.
enum class AluFunction : std::uint8_t { none, add, subtract, bit_and, bit_or, bit_xor, bit_and_not, bit_not };

/// Effect of an instruction on a cell's E.
enum class EnableFunction : std::uint8_t {
  keep,
  set,
  invert,
  load,  ///< from a field of one bit, as the next four
  and_field,
  and_not_field,
  or_field,
  xor_field,
  where_not_negative,  ///< where F >= 0
  where_negative,
  where_holds,  ///< where the comparison holds
  where_fits,   ///< the same; F is written there and must fit
};

/// Effect of the opcode on a cell's E.
EnableFunction enable_function_of(isa::Opcode opcode);

/// Sequential work of a cell on a packet's operands after all have arrived: the shifter aligns operands, then the ALU
/// processes them, lowest bits first. Functions of the sign of F, or of a single bit and E, take no work.
struct CellWork {
  std::array<Move, 2> moves{};
  AluFunction function = AluFunction::none;
  std::uint32_t bits = 0;  ///< bits that the ALU processes

  constexpr bool operator==(const CellWork&) const = default;
};

/// A unit of work that moves from cell to cell, or from level to level of a tree, one beat per clock. It occupies each
/// cell for `beats` clocks. In each of the first `words` clocks, one word of F and one word of its difference to the
/// next cell arrive, least significant first, and with squares one word of the second difference; then the cell
/// processes what it has received.
struct Packet {
  PacketKind kind = PacketKind::none;
  bool begins_line = false;  ///< clears the cell's memory and enable before the cell acts
  /// Whether this is the mark of a line that shows only the background, which is the instruction's constant.
  bool background = false;
  Keep keep = Keep::nothing;  ///< state that is copied from each cell when the packet leaves it, for run listeners
  std::uint32_t words = 1;
  std::uint32_t beats = 1;
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< index of the instruction in the segment
  std::int64_t square = 0;  ///< factor of x*x in F
  Accesses accesses{};
  CellWork work{};
  isa::Instruction instruction{};  ///< the instruction; in a mark with `background` only its constant is valid

  /// Whether words of F arrive with the packet.
  [[nodiscard]] constexpr bool brings_f() const {
    return kind == PacketKind::instruction && instruction.linear.width > 0;
  }
  constexpr bool operator==(const Packet&) const = default;
};

/// A beat in a cell, or on its way to a cell, in one clock.
struct Beat {
  const Packet* packet = nullptr;  ///< valid until the end of the clock; null if there is no beat
  std::uint32_t number = 0;        ///< index of the beat in the packet

  [[nodiscard]] constexpr bool last() const { return number + 1 == packet->beats; }
  constexpr bool operator==(const Beat&) const = default;
};

/// Words that arrive at a cell of a chain with a beat.
struct BeatWords {
  std::uint64_t f = 0;  ///< word of F in that cell
  /// Word of the difference between F in the next cell and in this cell; A if there are no squares.
  std::uint64_t a = 0;
  std::uint64_t aa = 0;  ///< word of the second difference

  constexpr bool operator==(const BeatWords&) const = default;
};

/// Output of a chain's refresh port in one clock.
struct RefreshPixel {
  bool valid = false;
  std::uint32_t colour = 0;

  constexpr bool operator==(const RefreshPixel&) const = default;
};

/// Packet of an instruction. `squares`: coefficients of a preceding instruction `squares`, of which only the factor of
/// x*x matters, because a line is a single row, number 0. The instruction `squares` itself delivers nothing to the
/// cells.
Packet instruction_packet(const isa::Instruction& instruction, const CellShape& cell, const isa::Linear& squares = {});
/// Packet that clears the cells at the start of a line and enters for `clocks` clocks.
Packet clear_packet(std::uint32_t clocks);
/// Mark at the end of a line: each cell holds its field `colour` for the refresh.
Packet mark_packet(isa::Field colour, const CellShape& cell);
/// Mark of a line that shows only the background, in a field as wide as `colour`.
Packet background_packet(isa::Field colour, std::uint32_t background, const CellShape& cell);

/// Words that arrive at cell `cell_index` with the beat, after the adders of the preceding cells have processed C, A
/// and the second difference.
BeatWords arriving_words(const Beat& beat, std::uint32_t cell_index, const CellShape& cell);

/// The low 64 bits of C + A*x + S*x*x, S being the factor of x*x, that have arrived at cell `cell_index` with the first
/// `beat_count` beats of a packet with F.
std::uint64_t received_sum(const Packet& packet, std::uint32_t beat_count, std::uint32_t cell_index,
                           const CellShape& cell);

/// Bits that the ALU processes per clock; `bits` if the ALU has no limit.
constexpr std::uint32_t alu_width(const CellShape& cell, std::uint32_t bits) {
  if (cell.alu_bits == 0) return bits;
  return cell.alu_bits < cell.word_bits ? cell.alu_bits : cell.word_bits;
}

}  // namespace csgsim::scan_line
