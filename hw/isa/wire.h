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

/// The instruction stream as it crosses the link from host to machine.
///
/// A command is its number, then its operands, each number with its least significant bit first: bit 0 of the command
/// is bit 0 of its first link word. A command begins at a new word, and the unused bits of its last word are 0.
namespace csgsim::isa {

// Widths on the link, in bits; that of a command's number is opcode_bits.
inline constexpr unsigned wire_base_bits = 12;         ///< base of a field
inline constexpr unsigned wire_field_width_bits = 6;   ///< width of a field
inline constexpr unsigned wire_linear_width_bits = 6;  ///< width of a linear expression or of squares
inline constexpr unsigned wire_shift_bits =
    6;  ///< its shift; then come A, B and C, each in `width` bits; squares have none
inline constexpr unsigned wire_count_bits = 32;   ///< a count; a constant is as wide as its target
inline constexpr unsigned wire_region_bits = 16;  ///< x, y, width and height of a segment, each

// Commands other than instructions; their numbers are no opcodes.

/// The instructions to come are for these pixels, whose memory and enable become 0.
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
  Field colour;  ///< of pixel memory, which is to be shown; of width 0 where nothing is

  constexpr bool operator==(const FrameEnd&) const = default;
};

using Command = std::variant<SegmentStart, Instruction, SegmentEnd, FrameEnd>;

/// The same F at every pixel from coefficients of `width` bits: each reduced modulo 2^width, to the number of that many
/// bits in two's complement. Whether A*x + B*y + C itself fits the width, which counts as an overflow where it does
/// not, can change if a coefficient did not fit.
Linear reduced(const Linear& linear);

/// What arrives of a valid instruction: no origin, and its linear expression or squares reduced.
Instruction as_received(const Instruction& instruction);

/// Bits of a command, and words that it takes on a link of that many bits.
unsigned wire_bits(const Command& command);
unsigned wire_words(const Command& command, unsigned link_width);

/// Bits of the numbers of an instruction that is on a link or kept as it came, in order, its own number first; numbers
/// of no bits are left out.
class WireFields {
 public:
  static constexpr std::size_t most = 13;

  explicit WireFields(const Instruction& instruction);

  [[nodiscard]] std::span<const std::uint8_t> widths() const { return std::span(widths_).first(count_); }

 private:
  std::array<std::uint8_t, most> widths_{};
  std::size_t count_ = 0;
};

/// All bits of a command as one word. Throws std::invalid_argument unless it is valid.
LinkWord packed(const Command& command);

/// Throws InputError unless a link can have that many bits, 1 to LinkWord::most_bits.
void check_link_width(unsigned link_width);

/// Calls sink(word) for each word of a valid command.
template <std::invocable<const LinkWord&> Sink>
void encode(const Command& command, unsigned link_width, Sink&& sink) {
  check_link_width(link_width);
  const LinkWord bits = packed(command);
  const unsigned count = wire_bits(command);
  for (unsigned first = 0; first < count; first += link_width) sink(bits.slice(first, link_width));
}

/// The receiving end: a shift register that gathers words until the command in it is whole. What is in tells how much
/// is to come: the number which operands, a linear expression's width how long A, B and C are, a target's how long its
/// constant.
class WireDecoder {
 public:
  /// Throws InputError as check_link_width does.
  explicit WireDecoder(unsigned link_width);

  /// The next word, of which only the link's width is looked at. Returns the command that ends with it, if one does;
  /// its instruction is valid on the largest memory. Throws InputError for a number that is no command's, for a command
  /// that is not valid, and for unused bits that are not 0; the word after that begins a command.
  std::optional<Command> take(const LinkWord& word);

  /// Is the next word the first of a command?
  [[nodiscard]] bool between_commands() const { return gathered_ == 0; }

 private:
  std::optional<Command> look();
  void begin_command();

  unsigned link_width_;
  LinkWord register_;
  unsigned gathered_ = 0;          ///< bits in the register
  unsigned wanted_ = opcode_bits;  ///< bits known to belong to the command
  bool lost_ = false;              ///< has a bit beyond the register been 1?
};

}  // namespace csgsim::isa
