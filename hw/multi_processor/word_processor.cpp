#include "hw/multi_processor/word_processor.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/list_wire.h"

namespace csgsim::multi_processor {

namespace {

constexpr unsigned sum_bits = 64;

/// Whether the opcode combines E with a bit of memory or loads it.
bool reads_first_bit(isa::Opcode opcode) {
  constexpr auto all =
      std::to_array<isa::Opcode>({isa::Opcode::enable_load, isa::Opcode::enable_and, isa::Opcode::enable_and_not,
                                  isa::Opcode::enable_or, isa::Opcode::enable_xor});
  return std::find(all.begin(), all.end(), opcode) != all.end();
}

}  // namespace

void WordProcessor::fetch(const isa::Instruction& instruction, const ListForm& form) {
  spend(loop_.instruction);
  read_words(static_cast<unsigned>(entry_bits(instruction, form)));
  const std::vector<unsigned> numbers = entry_widths(instruction, form);
  unpack(std::span(numbers));
  if (!uses_index(instruction, form)) return;
  read_words(form.record_bits);
  unpack(std::span(form.record_numbers));
  spend(list_clocks_);
}

/// All operands except the opcode get separate words in the chain.
void WordProcessor::link(const isa::Instruction& instruction, const ListForm& form) {
  fetch(instruction, form);
  spend(chain_.link);
  const isa::WireFields fields(instruction);
  for (const unsigned width : fields.widths().subspan(1)) write_words(width);
}

void WordProcessor::call(const isa::Instruction& instruction) {
  spend(chain_.call);
  const isa::WireFields fields(instruction);
  for (const unsigned width : fields.widths().subspan(1)) read_words(width);
}

/// Shifts by whole words cost nothing, since only addresses change; each remaining word also takes bits from the next.
void WordProcessor::shift_words(unsigned bits, unsigned places) {
  const unsigned rest = places % word_bits_;
  const std::uint64_t whole = places / word_bits_;
  if (rest == 0) return;
  std::uint64_t left = words(bits) > whole ? words(bits) - whole : 1;
  for (; left > 0; --left) {
    shift_word(rest);
    if (left == 1) continue;
    shift_word(word_bits_ - rest);
    combine_words(1);
  }
}

/// Unpacks a number that begins at bit `first_bit` of a word: its bits in other words are shifted into place, and its
/// last word is masked.
void WordProcessor::unpack(unsigned bits, unsigned first_bit) {
  spend(field_clocks_);
  const std::uint64_t from = words(first_bit + bits);
  for (std::uint64_t word = 0; first_bit > 0 && word < words(bits); ++word) {
    shift_word(first_bit);
    if (word + 1 == from) continue;
    shift_word(word_bits_ - first_bit);
    combine_words(1);
  }
  if (bits % word_bits_ != 0) combine_words(1);
}

std::uint64_t WordProcessor::multiply(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t factor) {
  spend(words(linear.width) * operations_.multiply);
  return static_cast<std::uint64_t>(coefficient) * factor;
}

std::uint64_t WordProcessor::start(const isa::Linear& linear, std::uint32_t x, std::uint32_t y) {
  auto sum = static_cast<std::uint64_t>(linear.c);
  add(linear, sum, multiply(linear, linear.a, x));
  add(linear, sum, multiply(linear, linear.b, y));
  return sum;
}

std::uint64_t WordProcessor::step(const isa::Linear& linear, std::int64_t coefficient, std::uint32_t distance) {
  return multiply(linear, coefficient, distance);
}

void WordProcessor::add(const isa::Linear& linear, std::uint64_t& sum, std::uint64_t step) {
  add_words(linear.width);
  sum += step;
}

std::uint32_t WordProcessor::load_colour(const PixelMemory& memory, std::size_t pixel, isa::Field colour) {
  return static_cast<std::uint32_t>(read(memory, pixel, colour));
}

std::uint64_t WordProcessor::read(const PixelMemory& memory, std::size_t pixel, isa::Field field) {
  read_words(field.width);
  return memory.read(pixel, field);
}

void WordProcessor::write_enable(PixelMemory& memory, std::size_t pixel, bool is_enabled) {
  write_words(1);
  memory.enable(pixel, is_enabled);
}

void WordProcessor::write(PixelMemory& memory, std::size_t pixel, isa::Field field, std::uint64_t value,
                          bool is_selected) {
  write_words(field.width);
  if (is_selected) memory.write(pixel, field, value);
}

/// The low `width` bits as a two's complement number, arithmetically shifted right (floor).
std::int64_t WordProcessor::extract_value(std::uint64_t sum, const isa::Linear& linear) {
  shift_words(linear.width, linear.shift);
  const unsigned unused = sum_bits - linear.width;
  return static_cast<std::int64_t>(sum << unused) >> unused >> linear.shift;
}

void WordProcessor::branch(bool is_taken) {
  if (branches_.over == Branches::none) return;
  unbranched_clocks_ += branches_.passed;
  if (skipping_) return;
  clocks_ += is_taken ? branches_.taken : branches_.passed;
  skipping_ = is_taken;
}

void WordProcessor::test_enable(const isa::Instruction& instruction, const PixelMemory& memory, std::size_t pixel) {
  read_words(1);
  combine_words(1);
  if (!isa::acts_on_disabled(instruction.opcode)) branch(!memory.enabled(pixel));
}

void WordProcessor::act(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel,
                        std::uint64_t sum) {
  const isa::Linear& linear = instruction.linear;
  execute_opcode(instruction, memory, pixel, linear.width > 0 ? extract_value(sum, linear) : 0);
  skipping_ = false;
}

void WordProcessor::execute_opcode(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel,
                                   std::int64_t linear_value) {
  using isa::Opcode;
  const isa::Field first = instruction.fields[0];
  const isa::Field second = instruction.fields[1];
  const isa::Field third = instruction.fields[2];
  const isa::Linear& linear = instruction.linear;
  const bool e = memory.enabled(pixel);
  const auto enable = [&](bool value) { write_enable(memory, pixel, value); };
  const auto take = [&](isa::Field field) { return read(memory, pixel, field); };
  const auto put = [&](std::uint64_t value) { write(memory, pixel, first, value, e); };
  const bool bit = reads_first_bit(instruction.opcode) && take(first) != 0;
  const auto compare_operand = [&] {
    const auto number = static_cast<std::int64_t>(take(first));
    compare_words(std::max<unsigned>(linear.width, first.width));
    return number;
  };
  const auto number = [&](isa::Field field) { return static_cast<std::int64_t>(take(field)); };
  const auto load = [&](bool where) { write_linear(instruction, memory, pixel, linear_value, where && e); };
  const auto keep = [&](bool where) {
    branch(!where);
    load(where);
  };

  switch (instruction.opcode) {
    case Opcode::enable_all: return enable(true);
    case Opcode::enable_invert: return enable(!e);
    case Opcode::enable_load: return enable(bit);
    case Opcode::enable_or: return enable(e || bit);
    case Opcode::enable_xor: return enable(e != bit);
    case Opcode::enable_and: return enable(e && bit);
    case Opcode::enable_and_not: return enable(e && !bit);
    case Opcode::enable_store: return write(memory, pixel, first, e ? 1 : 0, true);
    case Opcode::edge_not_negative: compare_words(1); return enable(linear_value >= 0 && e);
    case Opcode::edge_negative:
    case Opcode::stripe: compare_words(1); return enable(linear_value < 0 && e);
    case Opcode::linear_ge: return enable(linear_value >= compare_operand() && e);
    case Opcode::linear_gt: return enable(linear_value > compare_operand() && e);
    case Opcode::linear_le: return enable(linear_value <= compare_operand() && e);
    case Opcode::linear_lt: return enable(linear_value < compare_operand() && e);
    case Opcode::linear_eq: return enable(linear_value == compare_operand() && e);
    case Opcode::load_linear: return load(true);
    case Opcode::keep_max: return keep(linear_value > compare_operand());
    case Opcode::keep_min: return keep(linear_value < compare_operand());
    case Opcode::set_constant: return put(instruction.constant);
    case Opcode::copy: return put(take(second));
    case Opcode::field_lt: return enable(compare_operand() < number(second) && e);
    case Opcode::field_le: return enable(compare_operand() <= number(second) && e);
    case Opcode::field_eq: return enable(compare_operand() == number(second) && e);
    case Opcode::bit_and: combine_words(first.width); return put(take(second) & take(third));
    case Opcode::bit_or: combine_words(first.width); return put(take(second) | take(third));
    case Opcode::bit_xor: combine_words(first.width); return put(take(second) ^ take(third));
    case Opcode::bit_and_not: combine_words(first.width); return put(take(second) & ~take(third));
    case Opcode::bit_not: combine_words(first.width); return put(~take(second));
    case Opcode::xor_constant: combine_words(first.width); return put(take(first) ^ instruction.constant);
    case Opcode::add: add_words(first.width); return put(take(first) + take(second));
    case Opcode::global_or:
    case Opcode::skip_if_none: return;
    case Opcode::linear_plus:
      add_words(linear.width);
      return put(static_cast<std::uint64_t>(linear_value) + take(first));
    case Opcode::linear_minus:
      add_words(linear.width);
      return put(static_cast<std::uint64_t>(linear_value) - take(first));
    case Opcode::root: return put(compute_root(take(first), first.width / 2U));
    case Opcode::squares: throw std::logic_error("squares instruction on a machine of degree 1");
  }
}

/// Square root of a number of 2 x `bits` bits, and its remainder. The root is found bit by bit from the top: each trial
/// shifts two bits into the remainder, forms the number to add or subtract by a shift of two places, adds it, and tests
/// the sign.
std::uint64_t WordProcessor::compute_root(std::uint64_t field, unsigned bits) {
  const std::uint64_t radicand = field & ((std::uint64_t{1} << (2 * bits)) - 1);
  std::int64_t remainder = 0;
  std::int64_t root = 0;
  for (unsigned found = 0; found < bits; ++found) {
    shift_words(found + 3, 2);
    combine_words(found + 3);
    const auto two_bits = static_cast<std::int64_t>(radicand >> (2 * (bits - 1 - found)) & 3U);
    shift_words(found + 3, 2);
    combine_words(found + 3);
    const std::int64_t change = remainder < 0 ? 4 * root + 3 : -(4 * root + 1);
    add_words(found + 3);
    remainder = 4 * remainder + two_bits + change;
    compare_words(found + 3);
    root = 2 * root + (remainder < 0 ? 0 : 1);
  }
  const std::uint64_t left = static_cast<std::uint64_t>(remainder) & ((std::uint64_t{2} << bits) - 1);
  return static_cast<std::uint64_t>(root) << (bits + 1) | left;
}

/// Writes F to the target field where `is_selected` is true, and disables the pixel if F does not fit there.
void WordProcessor::write_linear(const isa::Instruction& instruction, PixelMemory& memory, std::size_t pixel,
                                 std::int64_t linear_value, bool is_selected) {
  const isa::Field target = instruction.fields[0];
  write(memory, pixel, target, static_cast<std::uint64_t>(linear_value), is_selected);
  compare_words(instruction.linear.width);
  const bool fits = linear_value >= 0 && linear_value >> target.width == 0;
  write_enable(memory, pixel, memory.enabled(pixel) && (fits || !is_selected));
}

}  // namespace csgsim::multi_processor
