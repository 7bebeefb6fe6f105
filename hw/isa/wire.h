// Encodes commands for the link and decodes them.
// Used by hw.
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
// Squares have no shift. A, B and C come last, with `width` bits each.
inline constexpr unsigned wire_shift_bits = 6;    ///< shift of a linear expression
inline constexpr unsigned wire_count_bits = 32;   ///< a count; a constant is as wide as its target
inline constexpr unsigned wire_region_bits = 16;  ///< each of x, y, width and height of a segment

// Commands other than instructions. Their numbers are not opcodes.

/// Starts a segment: the following instructions are for the pixels of the region, whose memory and enable bits are
/// cleared.
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

/// The same expression with each coefficient reduced modulo 2^width to a two's complement number; F is the same at
/// every pixel. If a coefficient did not fit, A*x + B*y + C may fit the width only before or only after the reduction,
/// so overflow counts may differ.
Linear reduced(const Linear& linear);

/// A valid instruction as the machine receives it: without origin, and with reduced linear expression or squares.
Instruction as_received(const Instruction& instruction);

/// Length of a command in bits, and in words of a link of that width.
unsigned wire_bits(const Command& command);
unsigned wire_words(const Command& command, unsigned link_width);

/// Widths of the numbers that encode an instruction, in order of transmission, starting with the opcode. Numbers of
/// width 0 are omitted.
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
LinkWord pack_command(const Command& command);

/// Throws InputError unless the link width is 1 to LinkWord::max_bits.
void check_link_width(unsigned link_width);

/// Calls sink(word) for each word of a valid command.
template <std::invocable<const LinkWord&> Sink>
void encode(const Command& command, unsigned link_width, Sink&& sink) {
  check_link_width(link_width);
  const LinkWord bits = pack_command(command);
  const unsigned count = wire_bits(command);
  for (unsigned first = 0; first < count; first += link_width) sink(bits.slice(first, link_width));
}

/// The receiving end: a shift register collects words until a command is complete. The bits received determine how many
/// follow: the command number determines the operands, the width of a linear expression determines the length of A, B
/// and C, and the width of a target determines the length of its constant.
class WireDecoder {
 public:
  /// Throws InputError for an invalid width, see check_link_width().
  explicit WireDecoder(unsigned link_width);

  /// Processes the next word; bits beyond the link's width are ignored. Returns the command that ends with this word,
  /// if any; an instruction is valid for the largest memory. Throws InputError for an unknown command number, an
  /// invalid command, or unused bits that are not 0; the decoder then expects the first word of a command.
  std::optional<Command> take(const LinkWord& word);

  /// Whether the next word is the first of a command.
  [[nodiscard]] bool is_between_commands() const { return gathered_ == 0; }

 private:
  std::optional<Command> try_decode();
  void begin_command();

  unsigned link_width_;
  LinkWord register_;
  unsigned gathered_ = 0;          ///< bits in the register
  unsigned wanted_ = opcode_bits;  ///< bits known to belong to the command
  bool lost_ = false;              ///< whether a 1 bit arrived beyond the end of the register
};

}  // namespace csgsim::isa
