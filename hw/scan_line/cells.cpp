#include "hw/scan_line/cells.h"

#include <algorithm>
#include <stdexcept>

#include "hw/isa/opcodes.h"
#include "hw/scan_line/snapshot.h"

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t storage_bits = 64;

/// The low `width` bits as a two's complement number, shifted right with floor.
std::int64_t value_of_f(std::uint64_t sum, const isa::Linear& linear) {
  if (linear.width == 0) return 0;
  const unsigned unused = storage_bits - linear.width;
  return static_cast<std::int64_t>(sum << unused) >> unused >> linear.shift;
}

}  // namespace

Cells::Cells(std::uint32_t count, std::uint32_t memory_bits, const CellShape& shape)
    : memory_bits_(memory_bits),
      shape_(shape),
      word_mask_(~std::uint64_t{0} >> (storage_bits - shape.word_bits)),
      cell_words_((memory_bits + storage_bits - 1) / storage_bits),
      memory_(count * cell_words_),
      sum_(count),
      carry_(count),
      enable_(count),
      fetched_(count),
      words_fetched_(count),
      result_(count),
      writes_(count) {}

void Cells::add(std::uint32_t cell, PacketWord& word) {
  const bool first = word.number == 0;
  const std::uint64_t carry = first ? 0 : carry_[cell];
  const std::uint64_t place = word.f << (word.number * shape_.word_bits);
  sum_[cell] = first ? place : sum_[cell] | place;
  const std::uint64_t half = word.f + word.a;
  const std::uint64_t whole = half + carry;
  const bool beyond = shape_.word_bits == storage_bits ? half < word.f || whole < half : whole > word_mask_;
  carry_[cell] = beyond ? 1 : 0;
  word.f = whole & word_mask_;
}

void Cells::clear(std::uint32_t cell) {
  std::fill_n(&memory_[cell * cell_words_], cell_words_, 0U);
  enable_[cell] = 0;
}

std::uint64_t Cells::read(std::uint32_t cell, isa::Field field) const { return read_field(memory(cell), field); }

void Cells::write(std::uint32_t cell, isa::Field field, std::uint64_t value) {
  const std::uint64_t mask = (std::uint64_t{1} << field.width) - 1;
  const unsigned shift = field.base % storage_bits;
  std::uint64_t* const word = &memory_[cell * cell_words_ + field.base / storage_bits];
  value &= mask;
  word[0] = (word[0] & ~(mask << shift)) | value << shift;
  if (shift + field.width <= storage_bits) return;
  word[1] = (word[1] & ~(mask >> (storage_bits - shift))) | value >> (storage_bits - shift);
}

/// The part of the field in one of its words.
isa::Field Cells::part_in(const FieldWords& words, std::uint32_t word) const {
  const std::uint32_t word_base = (words.first + word) * shape_.word_bits;
  const std::uint32_t first = std::max<std::uint32_t>(words.field.base, word_base);
  const std::uint32_t end = std::min<std::uint32_t>(words.field.end(), word_base + shape_.word_bits);
  return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end - first)};
}

void Cells::fetch(std::uint32_t cell, const PacketWord& beat) {
  const auto& [first, second] = beat.accesses.sources;
  if (beat.number == 0) {
    fetched_[cell] = {};
    words_fetched_[cell] = 0;
  }
  const std::uint32_t words = std::uint32_t{first.count} + second.count;
  std::uint32_t& done = words_fetched_[cell];
  const std::uint32_t end = shape_.ports == 0 ? words : std::min(words, done + shape_.ports);
  for (; done < end; ++done) {
    const bool of_first = done < first.count;
    const FieldWords& source = of_first ? first : second;
    const isa::Field part = part_in(source, of_first ? done : done - first.count);
    fetched_[cell][of_first ? 0 : 1] |= read(cell, part) << (part.base - source.field.base);
  }
}

void Cells::act(std::uint32_t cell, const PacketWord& beat) {
  const auto& [first, second] = beat.accesses.sources;
  if (words_fetched_[cell] < std::uint32_t{first.count} + second.count)
    throw std::logic_error("a cell acts before its ports have read the fields");
  const Result result = result_of(cell, beat.instruction);
  enable_[cell] = result.enable ? 1 : 0;
  writes_[cell] = result.writes ? 1 : 0;
  result_[cell] = result.value;
}

/// In the clocks from that of the result on.
void Cells::store(std::uint32_t cell, const PacketWord& beat) {
  const FieldWords& target = beat.accesses.target;
  if (writes_[cell] == 0 || target.count == 0) return;
  const std::uint32_t first = shape_.ports == 0 ? 0 : (beat.number - beat.accesses.result) * shape_.ports;
  const std::uint32_t end =
      shape_.ports == 0 ? target.count : std::min<std::uint32_t>(target.count, first + shape_.ports);
  for (std::uint32_t word = first; word < end; ++word) {
    const isa::Field part = part_in(target, word);
    write(cell, part, result_[cell] >> (part.base - target.field.base));
  }
}

Cells::Result Cells::result_of(std::uint32_t cell, const isa::Instruction& instruction) const {
  using isa::Opcode;
  const bool e = enabled(cell);
  const std::uint64_t first = fetched_[cell][0];
  const std::uint64_t second = fetched_[cell][1];
  const auto number = static_cast<std::int64_t>(first);
  const auto bit = first != 0;
  const std::int64_t f = value_of_f(sum_[cell], instruction.linear);
  const auto enable = [](bool value) { return Result{.enable = value}; };
  const auto write = [e](std::uint64_t value) { return Result{.enable = e, .writes = e, .value = value}; };
  // Disables the cell if the number does not fit.
  const auto write_linear = [&](bool writes) {
    const bool fits = f >= 0 && f >> instruction.fields[0].width == 0;
    return Result{.enable = e && (fits || !writes), .writes = e && writes, .value = static_cast<std::uint64_t>(f)};
  };

  switch (instruction.opcode) {
    case Opcode::enable_all: return enable(true);
    case Opcode::enable_invert: return enable(!e);
    case Opcode::enable_load: return enable(bit);
    case Opcode::enable_or: return enable(e || bit);
    case Opcode::enable_xor: return enable(e != bit);
    case Opcode::enable_store: return {.enable = e, .writes = true, .value = e ? 1U : 0U};
    case Opcode::enable_and: return enable(e && bit);
    case Opcode::enable_and_not: return enable(e && !bit);
    case Opcode::edge_not_negative: return enable(e && f >= 0);
    case Opcode::edge_negative:
    case Opcode::stripe: return enable(e && f < 0);
    case Opcode::linear_ge: return enable(e && f >= number);
    case Opcode::linear_gt: return enable(e && f > number);
    case Opcode::linear_le: return enable(e && f <= number);
    case Opcode::linear_lt: return enable(e && f < number);
    case Opcode::linear_eq: return enable(e && f == number);
    case Opcode::load_linear: return write_linear(true);
    case Opcode::keep_max: return write_linear(f > number);
    case Opcode::keep_min: return write_linear(f < number);
    case Opcode::set_constant: return write(instruction.constant);
    case Opcode::copy: return write(first);
    case Opcode::field_lt: return enable(e && first < second);
    case Opcode::field_le: return enable(e && first <= second);
    case Opcode::field_eq: return enable(e && first == second);
    case Opcode::bit_and: return write(first & second);
    case Opcode::bit_or: return write(first | second);
    case Opcode::bit_xor: return write(first ^ second);
    case Opcode::bit_and_not: return write(first & ~second);
    case Opcode::bit_not: return write(~first);
    case Opcode::xor_constant: return write(first ^ instruction.constant);
    case Opcode::add: return write(first + second);
    case Opcode::global_or:
    case Opcode::skip_if_none: return enable(e);
    case Opcode::squares:
    case Opcode::linear_plus:
    case Opcode::linear_minus:
    case Opcode::root: throw std::logic_error("no work of a cell for the instruction");
  }
  return enable(e);
}

}  // namespace csgsim::scan_line
