#include "hw/isa/wire.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/isa/describe.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/validate.h"

namespace csgsim::isa {

namespace {

static_assert(max_memory_bits <= 1U << wire_base_bits);
static_assert(max_wide_field_width < 1U << wire_field_width_bits);
static_assert(max_linear_width < 1U << wire_linear_width_bits && max_linear_width <= 1U << wire_shift_bits);
static_assert(max_count < 1ULL << wire_count_bits);
static_assert(max_array_side < 1U << wire_region_bits);
static_assert(std::ranges::none_of(opcode_table, [](const OpcodeInfo& row) {
  const auto number = static_cast<std::uint8_t>(row.opcode);
  return number == SegmentStart::number || number == SegmentEnd::number || number == FrameEnd::number;
}));

constexpr std::uint8_t number_of(const Instruction& instruction) {
  return static_cast<std::uint8_t>(instruction.opcode);
}

template <class Control>
constexpr std::uint8_t number_of(const Control& /*control*/) {
  return Control::number;
}

// pass(stream, command) calls stream(bits, member) for each number of a command after its opcode, in link order.
// Encoder, decoder and length computation share these lists.

template <class Stream, Any<Field> T>
constexpr void pass(Stream& stream, T& field) {
  stream(wire_base_bits, field.base);
  stream(wire_field_width_bits, field.width);
}

template <class Stream, Any<Linear> T>
constexpr void pass(Stream& stream, T& linear, bool has_shift) {
  stream(wire_linear_width_bits, linear.width);
  if (has_shift) stream(wire_shift_bits, linear.shift);
  stream(linear.width, linear.a);
  stream(linear.width, linear.b);
  stream(linear.width, linear.c);
}

template <class Stream, Any<Instruction> T>
constexpr void pass(Stream& stream, T& instruction) {
  const Operands& operands = info(instruction.opcode).operands;
  for (std::size_t i = 0; i < max_operands; ++i) {
    switch (operands[i]) {
      case OperandKind::none: break;
      case OperandKind::target:
      case OperandKind::source: pass(stream, instruction.fields[i]); break;
      case OperandKind::linear: pass(stream, instruction.linear, true); break;
      case OperandKind::squares: pass(stream, instruction.linear, false); break;
      case OperandKind::constant: stream(instruction.fields[0].width, instruction.constant); break;
      case OperandKind::count: stream(wire_count_bits, instruction.constant); break;
    }
  }
}

template <class Stream, Any<SegmentStart> T>
constexpr void pass(Stream& stream, T& start) {
  stream(wire_region_bits, start.region.x);
  stream(wire_region_bits, start.region.y);
  stream(wire_region_bits, start.region.width);
  stream(wire_region_bits, start.region.height);
}

template <class Stream, Any<SegmentEnd> T>
constexpr void pass(Stream& /*stream*/, T& /*end*/) {}

template <class Stream, Any<FrameEnd> T>
constexpr void pass(Stream& stream, T& end) {
  pass(stream, end.colour);
}

struct Measure {
  unsigned bits = opcode_bits;

  template <class Number>
  constexpr void operator()(unsigned count, const Number& /*number*/) {
    bits += count;
  }
};

constexpr unsigned bits_of(const auto& command) {
  Measure measure;
  pass(measure, command);
  return measure.bits;
}

constexpr Field widest_field{0, max_wide_field_width};
static_assert(std::ranges::all_of(opcode_table,
                                  [](const OpcodeInfo& row) {
                                    const Instruction longest{row.opcode,
                                                              {widest_field, widest_field, widest_field},
                                                              {0, 0, 0, max_linear_width, 0},
                                                              0,
                                                              {}};
                                    return bits_of(longest) <= LinkWord::max_bits;
                                  }),
              "the decoder's register holds the longest command");

constexpr std::uint64_t low_bits(std::uint64_t number, unsigned count) {
  return count == 0 ? 0 : number << (64 - count) >> (64 - count);
}

/// The low `count` bits (0 to 64) as a two's complement number.
constexpr std::int64_t sign_extended(std::uint64_t number, unsigned count) {
  return count == 0 ? 0 : static_cast<std::int64_t>(number << (64 - count)) >> (64 - count);
}

class Packer {
 public:
  /// Appends the low bits of a coefficient; other numbers must fit.
  template <class Number>
  void operator()(unsigned count, Number number) {
    const auto all = static_cast<std::uint64_t>(number);
    if (count > 64 || packed_ + count > LinkWord::max_bits ||
        (std::is_unsigned_v<Number> && all != low_bits(all, count)))
      throw std::invalid_argument("invalid command for the link: one of its numbers has too many bits");
    word_.put(packed_, count, low_bits(all, count));
    packed_ += count;
  }

  [[nodiscard]] const LinkWord& word() const { return word_; }

 private:
  LinkWord word_;
  unsigned packed_ = 0;
};

/// Reads numbers up to the first number that has not arrived completely.
class Unpacker {
 public:
  Unpacker(const LinkWord& word, unsigned gathered) : word_(word), gathered_(gathered) {}

  template <class Number>
  void operator()(unsigned count, Number& number) {
    if (wanted_ > gathered_) return;
    const unsigned first = wanted_;
    wanted_ += count;
    if (wanted_ > LinkWord::max_bits)
      throw InputError(fmt::format("a command is longer than {} bits", LinkWord::max_bits));
    if (wanted_ > gathered_) return;
    if constexpr (std::is_signed_v<Number>) {
      number = sign_extended(word_.number(first, count), count);
    } else {
      number = static_cast<Number>(word_.number(first, count));
    }
  }

  /// Bits up to the end of the first incomplete number, or of the last number.
  [[nodiscard]] unsigned wanted() const { return wanted_; }

 private:
  const LinkWord& word_;
  unsigned gathered_;
  unsigned wanted_ = 0;
};

Command command_of(std::uint8_t number) {
  switch (number) {
    case SegmentStart::number: return SegmentStart{};
    case SegmentEnd::number: return SegmentEnd{};
    case FrameEnd::number: return FrameEnd{};
    default: break;
  }
  const auto opcode = static_cast<Opcode>(number);
  if (!in_table(opcode)) throw InputError(fmt::format("unknown command number {}", number));
  Instruction instruction;
  instruction.opcode = opcode;
  return instruction;
}

void check(const Instruction& instruction) { validate(instruction, max_memory_bits); }
void check(const SegmentStart& start) { validate_region(start.region, {max_array_side, max_array_side, 0}); }
void check(const SegmentEnd& /*end*/) {}
void check(const FrameEnd& end) {
  if (end.colour.width > max_field_width || end.colour.end() > max_memory_bits)
    throw InputError(
        fmt::format("the frame ends with a colour field of {} bits from bit {}; a field has at most {} bits, within "
                    "the {} bits of a pixel",
                    end.colour.width, end.colour.base, max_field_width, max_memory_bits));
}

}  // namespace

Linear reduced(const Linear& linear) {
  const auto reduce = [&](std::int64_t coefficient) {
    return sign_extended(static_cast<std::uint64_t>(coefficient), linear.width);
  };
  return {reduce(linear.a), reduce(linear.b), reduce(linear.c), linear.width, linear.shift};
}

Instruction as_received(const Instruction& instruction) {
  Instruction received = instruction;
  received.origin = {};
  received.linear = reduced(instruction.linear);
  return received;
}

unsigned wire_bits(const Command& command) {
  return std::visit([](const auto& one) { return bits_of(one); }, command);
}

WireFields::WireFields(const Instruction& instruction) {
  const auto stream = [this](unsigned bits, const auto& /*number*/) {
    if (bits > 0) widths_.at(count_++) = static_cast<std::uint8_t>(bits);
  };
  stream(opcode_bits, number_of(instruction));
  pass(stream, instruction);
}

unsigned wire_words(const Command& command, unsigned link_width) {
  check_link_width(link_width);
  return quotient_up(wire_bits(command), link_width);
}

LinkWord pack_command(const Command& command) {
  if (const auto* instruction = std::get_if<Instruction>(&command); instruction && !in_table(instruction->opcode))
    throw std::invalid_argument("invalid command for the link: its opcode is not in the table");
  Packer packer;
  std::visit(
      [&](const auto& one) {
        packer(opcode_bits, number_of(one));
        pass(packer, one);
      },
      command);
  return packer.word();
}

void check_link_width(unsigned link_width) {
  if (link_width < 1 || link_width > LinkWord::max_bits)
    throw InputError(fmt::format("a link is {} bits wide; it must have 1 to {} bits", link_width, LinkWord::max_bits));
}

WireDecoder::WireDecoder(unsigned link_width) : link_width_(link_width) { check_link_width(link_width); }

std::optional<Command> WireDecoder::take(const LinkWord& word) {
  const unsigned room = LinkWord::max_bits - gathered_;
  register_.put(gathered_, link_width_, word.slice(0, link_width_));
  lost_ |= link_width_ > room && word.slice(room, link_width_ - room) != LinkWord{};
  gathered_ = std::min(gathered_ + link_width_, LinkWord::max_bits);
  if (gathered_ < wanted_) return std::nullopt;
  try {
    std::optional<Command> command = try_decode();
    if (command) begin_command();
    return command;
  } catch (const InputError&) {
    begin_command();
    throw;
  }
}

/// The command in the register, if it is complete.
std::optional<Command> WireDecoder::try_decode() {
  Unpacker unpacker(register_, gathered_);
  std::uint8_t number = 0;
  unpacker(opcode_bits, number);
  Command command = command_of(number);
  std::visit([&](auto& one) { pass(unpacker, one); }, command);
  wanted_ = unpacker.wanted();
  if (wanted_ > gathered_) return std::nullopt;
  if (lost_ || register_.slice(wanted_, gathered_ - wanted_) != LinkWord{})
    throw InputError(fmt::format("bits after the command {} are not 0", number));
  std::visit([](const auto& one) { check(one); }, command);
  return command;
}

void WireDecoder::begin_command() {
  register_ = {};
  gathered_ = 0;
  wanted_ = opcode_bits;
  lost_ = false;
}

}  // namespace csgsim::isa
