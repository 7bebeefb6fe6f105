// Encodes commands for the link and decodes them.
// Used by hw/link, hw/division and all machines.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "hw/isa/instruction.h"
#include "hw/isa/link_word.h"
#include "hw/isa/program.h"

/// The encoding of the instruction stream on the link from host to machine.
///
/// A command is its number followed by its operands, each with its least significant bit first; bit 0 of the command is
/// bit 0 of its first link word. Each command begins at a new word, and unused bits of its last word are 0.
namespace csgsim::isa {

// Widths on the link, in bits; a command's number has opcode_bits.
inline constexpr unsigned wire_base_bits = 12;         ///< base of a field
inline constexpr unsigned wire_field_width_bits = 6;   ///< width of a field
inline constexpr unsigned wire_linear_width_bits = 6;  ///< width of a linear expression or of squares
// Squares have no shift. A, B and C follow the shift or the width of squares, with `width` bits each.
inline constexpr unsigned wire_shift_bits = 6;    ///< shift of a linear expression
inline constexpr unsigned wire_count_bits = 32;   ///< a count; a constant is as wide as its target
inline constexpr unsigned wire_region_bits = 16;  ///< each of x, y, width and height of a segment

// Commands other than instructions. Their numbers are not opcodes.

/// The following instructions are for these pixels; memory and enable bits of the pixels are cleared.
struct SegmentStart {
  static constexpr std::uint8_t number = 61;
  Region region;

  constexpr bool operator==(const SegmentStart&) const = default;
};

/// The segment's pixels are finished.
struct SegmentEnd {
  static constexpr std::uint8_t number = 62;

  constexpr bool operator==(const SegmentEnd&) const = default;
};

/// The picture is finished.
struct FrameEnd {
  static constexpr std::uint8_t number = 63;
  Field colour;  ///< displayed field of pixel memory; width 0 if nothing is displayed

  constexpr bool operator==(const FrameEnd&) const = default;
};

using Command = std::variant<SegmentStart, Instruction, SegmentEnd, FrameEnd>;

/// The same F at every pixel with coefficients of `width` bits: each is reduced modulo 2^width to a two's complement
/// number. If a coefficient did not fit, A*x + B*y + C may fit the width only before or only after the reduction, so
/// overflow counts may differ.
Linear reduced(const Linear& linear);

/// A valid instruction as received: without origin, and with its linear expression or squares reduced.
Instruction as_received(const Instruction& instruction);

/// Length of a command in bits, and in words of a link of that width.
unsigned wire_bits(const Command& command);
unsigned wire_words(const Command& command, unsigned link_width);

/// Widths of the numbers of an instruction in link format, in order, its opcode first; numbers of no bits are omitted.
class WireFields {
 public:
  static constexpr std::size_t most = 13;

  explicit WireFields(const Instruction& instruction);

  [[nodiscard]] std::span<const std::uint8_t> widths() const { return std::span(widths_).first(count_); }

 private:
  std::array<std::uint8_t, most> widths_{};
  std::size_t count_ = 0;
};

/// All bits of a command as one word. Throws std::invalid_argument for an invalid command.
LinkWord packed(const Command& command);

/// Throws InputError unless the link width is 1 to LinkWord::most_bits.
void check_link_width(unsigned link_width);

/// Calls sink(word) for each word of a valid command.
template <std::invocable<const LinkWord&> Sink>
void encode(const Command& command, unsigned link_width, Sink&& sink) {
  check_link_width(link_width);
  const LinkWord bits = packed(command);
  const unsigned count = wire_bits(command);
  for (unsigned first = 0; first < count; first += link_width) sink(bits.slice(first, link_width));
}

/// The receiving end: a shift register collects words until its command is complete. The bits received determine how
/// many follow: the number determines the operands, the width of a linear expression the length of A, B and C, the
/// width of a target the length of its constant.
class WireDecoder {
 public:
  /// Throws InputError for an invalid width, see check_link_width().
  explicit WireDecoder(unsigned link_width);

  /// Takes the next word; bits beyond the link's width are ignored. Returns the command that ends with this word, if
  /// any; an instruction is valid for the largest memory. Throws InputError for an unknown command number, an invalid
  /// command, or unused bits that are not 0; the next word then begins a command.
  std::optional<Command> take(const LinkWord& word);

  /// Whether the next word is the first of a command.
  [[nodiscard]] bool between_commands() const { return gathered_ == 0; }

 private:
  std::optional<Command> look();
  void begin_command();

  unsigned link_width_;
  LinkWord register_;
  unsigned gathered_ = 0;          ///< bits in the register
  unsigned wanted_ = opcode_bits;  ///< bits known to belong to the command
  bool lost_ = false;              ///< whether a 1 bit arrived beyond the end of the register
};

}  // namespace csgsim::isa
