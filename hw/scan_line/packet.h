#pragma once

#include <array>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::scan_line {

using systemc::Keep;

/// What a cell is built of.
struct CellShape {
  std::uint32_t word_bits = 1;  ///< of a word of memory, of the adder and of the ALU: 1 to 64
  std::uint32_t ports = 0;      ///< words of memory that are read or written in a clock; 0 for any number

  constexpr bool operator==(const CellShape&) const = default;
};

enum class WordKind : std::uint8_t {
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

/// What a packet asks of a cell's memory. Reads begin with the packet's first word, at each port one a clock. The clock
/// of the result is the first in which all words of the packet are there and the last read is done, or, if something
/// is to be written, the ports are free again; the writes begin in it. A root has clocks of trials before its result,
/// which begin when the ports are free: its bit of number k takes as many as a sum of k + 3 bits has words.
struct Accesses {
  std::array<FieldWords, 2> sources{};  ///< read one after the other
  FieldWords target{};                  ///< written
  std::uint32_t result = 0;             ///< clock of the result, counted from the packet's first word in the cell
  std::uint32_t root_from = 0;          ///< of a root the clock of the first trial, which the result ends

  constexpr bool operator==(const Accesses&) const = default;
};

/// What moves from cell to cell, one a clock. A packet occupies each cell for `beats` clocks: in the first `words` of
/// them a word of F and of its difference to the next cell comes in, and with squares one of the second difference;
/// then the cell goes on with what it has. The packet's other fields stand with each beat here.
struct PacketWord {
  WordKind kind = WordKind::none;
  bool begins_line = false;   ///< clears the cell's memory and enable before the cell acts
  bool background = false;    ///< a mark for a line that shows the constant
  Keep keep = Keep::nothing;  ///< what to take down of the cells as the packet leaves them, for who watches the run
  std::uint32_t number = 0;   ///< of the beat; the least significant word of A and F comes first
  std::uint32_t words = 1;
  std::uint32_t beats = 1;
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< of the instruction in the segment
  std::uint64_t f = 0;      ///< word of F in the cell that the word is in
  std::uint64_t a = 0;      ///< word of F's difference to the next cell: without squares A
  std::uint64_t aa = 0;     ///< word of the second difference: twice the factor of x*x
  std::int64_t square = 0;  ///< that factor
  Accesses accesses{};
  isa::Instruction instruction{};  ///< of a mark with a background: only the constant

  [[nodiscard]] constexpr bool last() const { return number + 1 == beats; }
  constexpr bool operator==(const PacketWord&) const = default;
};

/// What comes out of a chain's refresh port in a clock.
struct RefreshPixel {
  bool valid = false;
  std::uint32_t colour = 0;

  constexpr bool operator==(const RefreshPixel&) const = default;
};

/// The first beat of a packet, as it enters cell 0, where F is C. `squares`: those of the instruction before. As a line
/// is one row, number 0, only their factor of x*x counts. Of an instruction `squares` itself the cells get nothing.
PacketWord instruction_packet(const isa::Instruction& instruction, const CellShape& cell,
                              const isa::Linear& squares = {});
PacketWord clear_packet(std::uint32_t clocks);
PacketWord mark_packet(isa::Field colour, const CellShape& cell);
/// For a line that shows the background, in a field as wide as `colour`.
PacketWord background_packet(isa::Field colour, std::uint32_t background, const CellShape& cell);

/// The beat after one that is not the last.
PacketWord next_beat(PacketWord beat, const CellShape& cell);

}  // namespace csgsim::scan_line
