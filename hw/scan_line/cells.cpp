#include "hw/scan_line/cells.h"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "hw/isa/opcodes.h"
#include "hw/systemc/field_bits.h"

namespace csgsim::scan_line {

namespace {

constexpr std::uint32_t storage_bits = 64;

/// The low bits of a word are 1; `bits` is below 64.
std::uint64_t low_bits(std::uint32_t bits) { return (std::uint64_t{1} << bits) - 1; }

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
      difference_carry_(count),
      enable_(count),
      fetched_(count),
      words_fetched_(count),
      alus_(count),
      roots_(count),
      result_(count),
      writes_(count) {}

std::uint64_t Cells::add_words(std::uint64_t one, std::uint64_t other, std::uint8_t& carry) const {
  const std::uint64_t half = one + other;
  const std::uint64_t whole = half + carry;
  const bool beyond = shape_.word_bits == storage_bits ? half < one || whole < half : whole > word_mask_;
  carry = beyond ? 1 : 0;
  return whole & word_mask_;
}

void Cells::add(std::uint32_t cell, PacketWord& word) {
  const bool first = word.number == 0;
  const std::uint64_t place = word.f << (word.number * shape_.word_bits);
  sum_[cell] = first ? place : sum_[cell] | place;
  if (first) carry_[cell] = difference_carry_[cell] = 0;
  word.f = add_words(word.f, word.a, carry_[cell]);
  if (word.square != 0) word.a = add_words(word.a, word.aa, difference_carry_[cell]);
}

/// The bits of C + A*x + S*x*x, which the tree's adders form: they follow from the coefficients.
void Cells::take(std::uint32_t cell, const PacketWord& beat) {
  const isa::Linear& linear = beat.instruction.linear;
  const std::uint64_t x = cell;
  const std::uint64_t value = (static_cast<std::uint64_t>(beat.square) * x + static_cast<std::uint64_t>(linear.a)) * x +
                              static_cast<std::uint64_t>(linear.c);
  const std::uint32_t bits = f_bits(shape_);
  const std::uint32_t first = beat.number * bits;
  if (beat.number == 0) sum_[cell] = 0;
  if (first >= storage_bits) return;
  const std::uint64_t mask = ~std::uint64_t{0} >> (storage_bits - bits);
  sum_[cell] |= (value >> first & mask) << first;
}

void Cells::work(std::uint32_t cell, const PacketWord& beat) {
  CellAlu& alu = alus_[cell];
  if (beat.number == beat.accesses.work_from) alu.begin();
  alu.clock(beat.work, operands_of(cell, beat.instruction), shape_);
}

/// The root found so far takes the field's upper bits, which the remainder does not need any more; its bit k is tried
/// against k + 3 bits of the field.
void Cells::try_root(std::uint32_t cell, const PacketWord& beat) {
  Root& root = roots_[cell];
  std::uint64_t& value = fetched_[cell][0];
  const std::uint32_t bits = beat.accesses.target.field.width / 2U;
  if (beat.number == beat.accesses.work_from) {
    root = {};
    value &= low_bits(2 * bits);
  }
  const std::uint32_t length = root.bit + 3;
  const std::uint32_t lowest = 2 * (bits - 1 - root.bit);
  const std::uint32_t first = root.tried;
  const std::uint32_t count = std::min(alu_width(shape_, shape_.word_bits), length - first);
  const std::uint64_t found = value >> (2 * bits - root.bit) >> 1U;
  const std::uint64_t operand = root.negative ? 4 * found + 3 : ~(4 * found + 1);
  const bool carry = first == 0 ? !root.negative : root.carry;
  const std::uint64_t mask = low_bits(count);
  const std::uint64_t sum = (value >> (lowest + first) & mask) + (operand >> first & mask) + (carry ? 1U : 0U);
  value = (value & ~(mask << (lowest + first))) | (sum & mask) << (lowest + first);
  root.carry = (sum >> count & 1U) != 0;
  root.tried += count;
  if (root.tried < length) return;
  const std::uint64_t sign = std::uint64_t{1} << (lowest + length - 1);
  root.negative = (value & sign) != 0;
  value ^= sign;
  ++root.bit;
  root.tried = 0;
}

void Cells::clear(std::uint32_t cell) {
  std::fill_n(&memory_[cell * cell_words_], cell_words_, 0U);
  enable_[cell] = 0;
}

std::uint64_t Cells::read(std::uint32_t cell, isa::Field field) const {
  return systemc::read_field(memory(cell), field);
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
  if (!alus_[cell].done(beat.work, shape_))
    throw std::logic_error("a cell acts before its shifter and ALU are through");
  if (beat.instruction.opcode == isa::Opcode::root && roots_[cell].bit != beat.accesses.target.field.width / 2U)
    throw std::logic_error("a cell acts before it has found all bits of a root");
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
    systemc::write_field(std::span(memory_).subspan(cell * cell_words_, cell_words_), part,
                         result_[cell] >> (part.base - target.field.base));
  }
}

/// F is the first, where there is one; a constant is the second.
AluOperands Cells::operands_of(std::uint32_t cell, const isa::Instruction& instruction) const {
  const std::uint64_t first = fetched_[cell][0];
  if (instruction.linear.width > 0)
    return {static_cast<std::uint64_t>(value_of_f(sum_[cell], instruction.linear)), first, instruction.fields[0].width};
  const bool is_constant = instruction.opcode == isa::Opcode::xor_constant;
  return {first, is_constant ? instruction.constant : fetched_[cell][1], 0};
}

Cells::Result Cells::result_of(std::uint32_t cell, const isa::Instruction& instruction) const {
  using isa::Opcode;
  const bool e = enabled(cell);
  const CellAlu& alu = alus_[cell];
  const std::uint64_t first = fetched_[cell][0];
  const auto bit = first != 0;
  const std::int64_t f = value_of_f(sum_[cell], instruction.linear);
  const auto enable = [](bool value) { return Result{.enable = value}; };
  const auto write = [e](std::uint64_t value) { return Result{.enable = e, .writes = e, .value = value}; };
  // Disables the cell if the number does not fit.
  const auto write_linear = [&](bool writes) {
    return Result{
        .enable = e && (alu.fits() || !writes), .writes = e && writes, .value = static_cast<std::uint64_t>(f)};
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
    case Opcode::linear_ge: return enable(e && !alu.less());
    case Opcode::linear_gt: return enable(e && !alu.less() && !alu.equal());
    case Opcode::linear_le: return enable(e && (alu.less() || alu.equal()));
    case Opcode::linear_lt: return enable(e && alu.less());
    case Opcode::linear_eq: return enable(e && alu.equal());
    case Opcode::load_linear: return write_linear(true);
    case Opcode::keep_max: return write_linear(!alu.less() && !alu.equal());
    case Opcode::keep_min: return write_linear(alu.less());
    case Opcode::set_constant: return write(instruction.constant);
    case Opcode::copy: return write(first);
    case Opcode::field_lt: return enable(e && alu.below());
    case Opcode::field_le: return enable(e && (alu.below() || alu.equal()));
    case Opcode::field_eq: return enable(e && alu.equal());
    case Opcode::bit_and:
    case Opcode::bit_or:
    case Opcode::bit_xor:
    case Opcode::bit_and_not:
    case Opcode::bit_not:
    case Opcode::xor_constant:
    case Opcode::add:
    case Opcode::linear_plus:
    case Opcode::linear_minus: return write(alu.value());
    case Opcode::global_or:
    case Opcode::skip_if_none:
    case Opcode::squares: return enable(e);
    case Opcode::root: return write(first);
  }
  return enable(e);
}

}  // namespace csgsim::scan_line
