#pragma once

#include <cstdint>

#include "hw/isa/instruction.h"

namespace csgsim::scan_line {

/// What to take down of the cells as a packet leaves them, for who watches the run.
enum class Keep : std::uint8_t { nothing, enable, all };

enum class WordKind : std::uint8_t {
  none,
  instruction,  ///< one of the words of an instruction's packet
  mark,         ///< the end of a line: each cell holds its colour for the refresh
};

/// What moves from cell to cell, one a clock: a word of a packet. The packet's other fields stand in each of its words
/// here; cells use them with the last.
struct PacketWord {
  WordKind kind = WordKind::none;
  bool begins_line = false;  ///< clears the cell's memory and enable before the cell acts
  bool last = false;         ///< of its packet: the cell acts
  Keep keep = Keep::nothing;
  std::uint16_t number = 0;  ///< in the packet, the least significant word of A and F first
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< of the instruction in the segment
  std::uint64_t a = 0;      ///< word of A
  std::uint64_t f = 0;      ///< word of A*x + C, where x is the cell that the word is in
  /// Of a mark: fields[0] is the colour field; a line that is its mark alone shows the constant.
  isa::Instruction instruction{};

  constexpr bool operator==(const PacketWord&) const = default;
};

/// What comes out of a chain's refresh port in a clock.
struct RefreshPixel {
  bool valid = false;
  std::uint32_t colour = 0;

  constexpr bool operator==(const RefreshPixel&) const = default;
};

/// That word of a packet, as it enters cell 0, where F is C. A word has `word_bits` bits, 1 to 64.
PacketWord packet_word(const isa::Instruction& instruction, std::uint16_t number, std::uint32_t word_bits);

}  // namespace csgsim::scan_line
