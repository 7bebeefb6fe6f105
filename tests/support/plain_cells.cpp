#include "tests/support/plain_cells.h"

#include <algorithm>
#include <stdexcept>

#include "hw/isa/opcodes.h"
#include "hw/systemc/field_bits.h"

namespace csgsim::test {

namespace {

using scan_line::AluFunction;
using scan_line::Move;
using scan_line::PacketKind;

constexpr std::uint32_t storage_bits = 64;

/// Interprets the low `width` bits as a two's complement number and shifts it right, rounding down.
std::int64_t value_of_f(std::uint64_t sum, const isa::Linear& linear) {
  if (linear.width == 0) return 0;
  const unsigned unused = storage_bits - linear.width;
  return static_cast<std::int64_t>(sum << unused) >> unused >> linear.shift;
}

/// Word whose low `bits` bits are 1; `bits` is below 64.
constexpr std::uint64_t ones(std::uint32_t bits) { return (std::uint64_t{1} << bits) - 1; }

bool top_of(std::uint64_t value, std::uint32_t count) { return (value >> (count - 1) & 1U) != 0; }

std::uint64_t word_of(std::int64_t coefficient, std::uint32_t number, std::uint32_t word_bits) {
  const std::uint32_t low = number * word_bits;
  const auto shifted = static_cast<std::uint64_t>(coefficient >> std::min(low, storage_bits - 1));
  return word_bits == storage_bits ? shifted : shifted & ones(word_bits);
}

PlainBeat first_of(const scan_line::Beat& beat, const CellShape& cell) {
  PlainBeat first;
  static_cast<scan_line::Packet&>(first) = *beat.packet;
  first.number = beat.number;
  if (first.number >= first.words) return first;
  const isa::Linear& linear = first.instruction.linear;
  first.f = word_of(linear.c, first.number, f_bits(cell));
  first.a = word_of(linear.a + first.square, first.number, f_bits(cell));
  first.aa = word_of(2 * first.square, first.number, f_bits(cell));
  return first;
}

}  // namespace

bool PlainAlu::moves(const CellWork& work, const CellShape& cell) const {
  if (cell.shift_bits == 0) return false;
  return std::any_of(work.moves.begin() + static_cast<std::ptrdiff_t>(move_), work.moves.end(),
                     [](const Move& move) { return move.distance > 0; });
}

bool PlainAlu::is_done(const CellWork& work, const CellShape& cell) const {
  return !moves(work, cell) && taken_ == work.bits;
}

void PlainAlu::clock(const CellWork& work, const AluOperands& operands, const CellShape& cell) {
  if (moves(work, cell)) return advance_shift(work, cell);
  if (taken_ < work.bits) take(work, operands, std::min(alu_width(cell, work.bits), work.bits - taken_));
}

void PlainAlu::advance_shift(const CellWork& work, const CellShape& cell) {
  while (work.moves.at(move_).distance == 0) ++move_;
  const Move& move = work.moves.at(move_);
  moved_ += cell.shift_bits;
  if (moved_ < move.distance) return;
  moved_ = 0;
  if (++word_ < move.words) return;
  word_ = 0;
  ++move_;
}

void PlainAlu::take(const CellWork& work, const AluOperands& operands, std::uint32_t count) {
  const std::uint64_t mask = ones(count);
  const std::uint64_t x = operands.x >> taken_ & mask;
  const std::uint64_t y = operands.y >> taken_ & mask;
  const auto in = static_cast<std::uint64_t>(carry_);
  std::uint64_t sum = 0;
  switch (work.function) {
    case AluFunction::none: break;
    case AluFunction::add: sum = x + y + in; break;
    case AluFunction::subtract: sum = x - y - in; break;
    case AluFunction::bit_and: sum = x & y; break;
    case AluFunction::bit_or: sum = x | y; break;
    case AluFunction::bit_xor: sum = x ^ y; break;
    case AluFunction::bit_and_not: sum = x & ~y; break;
    case AluFunction::bit_not: sum = ~x & mask; break;
  }
  carry_ = (sum >> count & 1U) != 0;
  value_ |= (sum & mask) << taken_;
  differs_ = differs_ || (sum & mask) != 0;
  const std::uint32_t inside = std::clamp(operands.field_bits, taken_, taken_ + count) - taken_;
  beyond_ = beyond_ || (x & ~ones(inside)) != 0;
  negative_ = top_of(sum, count);
  negative_x_ = top_of(x, count);
  negative_y_ = top_of(y, count);
  taken_ += count;
}

PlainCells::PlainCells(std::uint32_t count, std::uint32_t memory_bits, const CellShape& shape)
    : shape_(shape),
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

std::uint64_t PlainCells::add_words(std::uint64_t left, std::uint64_t right, std::uint8_t& carry) const {
  const std::uint64_t half = left + right;
  const std::uint64_t whole = half + carry;
  const bool beyond = shape_.word_bits == storage_bits ? half < left || whole < half : whole > word_mask_;
  carry = beyond ? 1 : 0;
  return whole & word_mask_;
}

void PlainCells::add(std::uint32_t cell, PlainBeat& word) {
  const bool first = word.number == 0;
  const std::uint64_t place = word.f << (word.number * shape_.word_bits);
  sum_[cell] = first ? place : sum_[cell] | place;
  if (first) carry_[cell] = difference_carry_[cell] = 0;
  word.f = add_words(word.f, word.a, carry_[cell]);
  if (word.square != 0) word.a = add_words(word.a, word.aa, difference_carry_[cell]);
}

/// Computes C + A*x + S*x*x directly from the coefficients; the tree's adders form the same bits.
void PlainCells::take(std::uint32_t cell, const PlainBeat& beat) {
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

void PlainCells::work(std::uint32_t cell, const PlainBeat& beat) {
  PlainAlu& alu = alus_[cell];
  if (beat.number == beat.accesses.work_from) alu.begin();
  alu.clock(beat.work, operands_of(cell, beat.instruction), shape_);
}

/// The known root bits replace the upper bits of the field, which the remainder no longer needs. Bit k of the root
/// is tried against k + 3 bits of the field.
void PlainCells::try_root_bit(std::uint32_t cell, const PlainBeat& beat) {
  Root& root = roots_[cell];
  std::uint64_t& value = fetched_[cell][0];
  const std::uint32_t bits = beat.accesses.target.field.width / 2U;
  if (beat.number == beat.accesses.work_from) {
    root = {};
    value &= ones(2 * bits);
  }
  const std::uint32_t length = root.bit + 3;
  const std::uint32_t lowest = 2 * (bits - 1 - root.bit);
  const std::uint32_t first = root.tried;
  const std::uint32_t count = std::min(alu_width(shape_, shape_.word_bits), length - first);
  const std::uint64_t found = value >> (2 * bits - root.bit) >> 1U;
  const std::uint64_t operand = root.negative ? 4 * found + 3 : ~(4 * found + 1);
  const bool carry = first == 0 ? !root.negative : root.carry;
  const std::uint64_t mask = ones(count);
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

void PlainCells::clear(std::uint32_t cell) {
  std::fill_n(&memory_[cell * cell_words_], cell_words_, 0U);
  enable_[cell] = 0;
}

std::uint64_t PlainCells::read(std::uint32_t cell, isa::Field field) const {
  return systemc::read_field(memory(cell), field);
}

/// Part of the field inside one of its words.
isa::Field PlainCells::part_of_word(const FieldWords& words, std::uint32_t word) const {
  const std::uint32_t word_base = (words.first + word) * shape_.word_bits;
  const std::uint32_t first = std::max<std::uint32_t>(words.field.base, word_base);
  const std::uint32_t end = std::min<std::uint32_t>(words.field.end(), word_base + shape_.word_bits);
  return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(end - first)};
}

void PlainCells::fetch(std::uint32_t cell, const PlainBeat& beat) {
  const auto& [first, second] = beat.accesses.sources;
  if (beat.number == 0) {
    fetched_[cell] = {};
    words_fetched_[cell] = 0;
  }
  const std::uint32_t words = std::uint32_t{first.count} + second.count;
  std::uint32_t& fetched_count = words_fetched_[cell];
  const std::uint32_t end = shape_.ports == 0 ? words : std::min(words, fetched_count + shape_.ports);
  for (; fetched_count < end; ++fetched_count) {
    const bool of_first = fetched_count < first.count;
    const FieldWords& source = of_first ? first : second;
    const isa::Field part = part_of_word(source, of_first ? fetched_count : fetched_count - first.count);
    fetched_[cell][of_first ? 0 : 1] |= read(cell, part) << (part.base - source.field.base);
  }
}

void PlainCells::execute(std::uint32_t cell, const PlainBeat& beat) {
  const auto& [first, second] = beat.accesses.sources;
  if (words_fetched_[cell] < std::uint32_t{first.count} + second.count)
    throw std::logic_error("a cell acts before its ports have read the fields");
  if (!alus_[cell].is_done(beat.work, shape_))
    throw std::logic_error("a cell acts before its shifter and ALU have finished");
  if (beat.instruction.opcode == isa::Opcode::root && roots_[cell].bit != beat.accesses.target.field.width / 2U)
    throw std::logic_error("a cell acts before it has found all bits of a root");
  const Result result = result_of(cell, beat.instruction);
  enable_[cell] = result.enable ? 1 : 0;
  writes_[cell] = result.writes ? 1 : 0;
  result_[cell] = result.value;
}

/// Called in the clock of the result and in later ones.
void PlainCells::store(std::uint32_t cell, const PlainBeat& beat) {
  const FieldWords& target = beat.accesses.target;
  if (writes_[cell] == 0 || target.count == 0) return;
  const std::uint32_t first = shape_.ports == 0 ? 0 : (beat.number - beat.accesses.result) * shape_.ports;
  const std::uint32_t end =
      shape_.ports == 0 ? target.count : std::min<std::uint32_t>(target.count, first + shape_.ports);
  for (std::uint32_t word = first; word < end; ++word) {
    const isa::Field part = part_of_word(target, word);
    systemc::write_field(std::span(memory_).subspan(cell * cell_words_, cell_words_), part,
                         result_[cell] >> (part.base - target.field.base));
  }
}

/// F, if present, is the first operand; a constant is the second.
AluOperands PlainCells::operands_of(std::uint32_t cell, const isa::Instruction& instruction) const {
  const std::uint64_t first = fetched_[cell][0];
  if (instruction.linear.width > 0)
    return {static_cast<std::uint64_t>(value_of_f(sum_[cell], instruction.linear)), first, instruction.fields[0].width};
  const bool is_constant = instruction.opcode == isa::Opcode::xor_constant;
  return {first, is_constant ? instruction.constant : fetched_[cell][1], 0};
}

PlainCells::Result PlainCells::result_of(std::uint32_t cell, const isa::Instruction& instruction) const {
  using isa::Opcode;
  const bool e = enabled(cell);
  const PlainAlu& alu = alus_[cell];
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

PlainChain::PlainChain(std::uint32_t cells, std::uint32_t memory_bits, const CellShape& shape)
    : shape_(shape), cells_(cells, memory_bits, shape) {}

void PlainChain::step(const scan_line::Beat& entering) {
  if (entering.packet != nullptr) flights_.push_back({.beat = first_of(entering, shape_)});
  for (Flight& flight : flights_) {
    for (std::uint32_t cell = 0; cell < cells_.count(); ++cell)
      if (flight.moved == clocks_to(cell)) work(flight.beat, cell);
    ++flight.moved;
  }
  std::erase_if(flights_, [&](const Flight& flight) { return flight.moved > clocks_to(cells_.count() - 1); });
}

std::uint32_t PlainChain::clocks_to(std::uint32_t cell) const {
  const bool is_chain = shape_.tree_bits == 0;
  return clocks_to_cell(is_chain ? scan_line::Network::chain : scan_line::Network::trees, cells_.count(), cell);
}

const PlainBeat* PlainChain::beat_in(std::uint32_t cell) const {
  const auto found =
      std::find_if(flights_.begin(), flights_.end(), [&](const Flight& one) { return one.moved == clocks_to(cell); });
  return found == flights_.end() ? nullptr : &found->beat;
}

void PlainChain::work(PlainBeat& beat, std::uint32_t cell) {
  const bool is_last = beat.number + 1 == beat.beats;
  if ((beat.begins_line && beat.number == 0) || (beat.kind == PacketKind::clear && is_last)) cells_.clear(cell);
  if (beat.kind == PacketKind::mark) cells_.fetch(cell, beat);
  if (beat.kind != PacketKind::instruction) return;
  if (beat.number < beat.words && beat.brings_f()) {
    if (shape_.tree_bits == 0) {
      cells_.add(cell, beat);
    } else {
      cells_.take(cell, beat);
    }
  }
  cells_.fetch(cell, beat);
  if (beat.number >= beat.accesses.work_from && beat.number <= beat.accesses.result) {
    if (beat.instruction.opcode == isa::Opcode::root) cells_.try_root_bit(cell, beat);
    cells_.work(cell, beat);
  }
  if (beat.number == beat.accesses.result) cells_.execute(cell, beat);
  if (beat.number >= beat.accesses.result) cells_.store(cell, beat);
}

}  // namespace csgsim::test
