#include "hw/scan_line/cells.h"

#include <algorithm>

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

Cells::Cells(std::uint32_t count, std::uint32_t memory_bits, std::uint32_t word_bits)
    : memory_bits_(memory_bits),
      word_bits_(word_bits),
      word_mask_(~std::uint64_t{0} >> (storage_bits - word_bits)),
      cell_words_((memory_bits + storage_bits - 1) / storage_bits),
      memory_(count * cell_words_),
      sum_(count),
      carry_(count),
      enable_(count) {}

void Cells::add(std::uint32_t cell, PacketWord& word) {
  const bool first = word.number == 0;
  const std::uint64_t carry = first ? 0 : carry_[cell];
  const std::uint64_t place = word.f << (word.number * word_bits_);
  sum_[cell] = first ? place : sum_[cell] | place;
  const std::uint64_t half = word.f + word.a;
  const std::uint64_t whole = half + carry;
  const bool beyond = word_bits_ == storage_bits ? half < word.f || whole < half : whole > word_mask_;
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

/// Disables the cell if the number does not fit.
void Cells::write_linear(std::uint32_t cell, isa::Field field, std::int64_t value) {
  write(cell, field, static_cast<std::uint64_t>(value));
  if (value < 0 || value >> field.width != 0) enable_[cell] = 0;
}

void Cells::act(std::uint32_t cell, const isa::Instruction& instruction) {
  using isa::Opcode;
  const auto& [first, second, third] = instruction.fields;
  const bool e = enabled(cell);
  const auto enable = [&](bool value) { enable_[cell] = value ? 1 : 0; };
  const auto number = [&](isa::Field field) { return static_cast<std::int64_t>(read(cell, field)); };
  const auto bit = [&](isa::Field field) { return read(cell, field) != 0; };
  const auto f = [&] { return value_of_f(sum_[cell], instruction.linear); };

  switch (instruction.opcode) {
    case Opcode::enable_all: enable(true); return;
    case Opcode::enable_invert: enable(!e); return;
    case Opcode::enable_load: enable(bit(first)); return;
    case Opcode::enable_or: enable(e || bit(first)); return;
    case Opcode::enable_xor: enable(e != bit(first)); return;
    case Opcode::enable_store: write(cell, first, e ? 1 : 0); return;
    case Opcode::enable_and: enable(e && bit(first)); return;
    case Opcode::enable_and_not: enable(e && !bit(first)); return;
    case Opcode::edge_not_negative: enable(e && f() >= 0); return;
    case Opcode::edge_negative: enable(e && f() < 0); return;
    case Opcode::linear_ge: enable(e && f() >= number(first)); return;
    case Opcode::linear_gt: enable(e && f() > number(first)); return;
    case Opcode::linear_le: enable(e && f() <= number(first)); return;
    case Opcode::linear_lt: enable(e && f() < number(first)); return;
    case Opcode::linear_eq: enable(e && f() == number(first)); return;
    case Opcode::load_linear:
      if (e) write_linear(cell, first, f());
      return;
    case Opcode::keep_max:
      if (e && f() > number(first)) write_linear(cell, first, f());
      return;
    case Opcode::keep_min:
      if (e && f() < number(first)) write_linear(cell, first, f());
      return;
    case Opcode::set_constant:
      if (e) write(cell, first, instruction.constant);
      return;
    case Opcode::copy:
      if (e) write(cell, first, read(cell, second));
      return;
    case Opcode::field_lt: enable(e && number(first) < number(second)); return;
    case Opcode::field_le: enable(e && number(first) <= number(second)); return;
    case Opcode::field_eq: enable(e && number(first) == number(second)); return;
    case Opcode::bit_and:
      if (e) write(cell, first, read(cell, second) & read(cell, third));
      return;
    case Opcode::bit_or:
      if (e) write(cell, first, read(cell, second) | read(cell, third));
      return;
    case Opcode::bit_xor:
      if (e) write(cell, first, read(cell, second) ^ read(cell, third));
      return;
    case Opcode::bit_and_not:
      if (e) write(cell, first, read(cell, second) & ~read(cell, third));
      return;
    case Opcode::bit_not:
      if (e) write(cell, first, ~read(cell, second));
      return;
    case Opcode::xor_constant:
      if (e) write(cell, first, read(cell, first) ^ instruction.constant);
      return;
    case Opcode::global_or:
    case Opcode::skip_if_none: return;
  }
}

}  // namespace csgsim::scan_line
