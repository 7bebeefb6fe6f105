#include "tests/rtl/scan_line/cell_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"

namespace csgsim::rtl {

namespace {

using isa::Opcode;
using scan_line::AluFunction;
using scan_line::Move;
using scan_line::PacketKind;
using test::PlainBeat;
using test::PlainCells;

constexpr std::uint32_t all_bits = 128;

Bits low(Bits value, std::uint32_t bits) { return bits >= all_bits ? value : value & ((Bits{1} << bits) - 1); }

/// Extracts up to 64 bits.
std::uint64_t part_of(const Vector& from, std::size_t first, std::uint32_t count) {
  std::uint64_t value = from[first / 64] >> first % 64;
  if (first % 64 != 0 && first / 64 + 1 < from.size()) value |= from[first / 64 + 1] << (64 - first % 64);
  return static_cast<std::uint64_t>(low(value, count));
}

/// Number of words that a field of `bits` bits can touch.
std::uint32_t touched_words(std::uint32_t bits, std::uint32_t word_bits) {
  return quotient_up(word_bits - 1 + bits, word_bits);
}

std::string show(Bits value) {
  const auto high = static_cast<std::uint64_t>(value >> 64U);
  return fmt::format("{:x}{:016x}", high, static_cast<std::uint64_t>(value));
}

bool is_instruction(const PlainBeat& beat) { return beat.kind == PacketKind::instruction; }

bool is_linear(const PlainBeat& beat) { return is_instruction(beat) && beat.instruction.linear.width > 0; }

bool brings_words(const PlainBeat& beat) { return is_linear(beat) && beat.number < beat.words; }

/// Whether the ALU's value replaces the first operand.
bool stores(const PlainBeat& beat) {
  const Opcode opcode = beat.instruction.opcode;
  return beat.accesses.target.count > 0 && opcode != Opcode::load_linear && opcode != Opcode::keep_max &&
         opcode != Opcode::keep_min;
}

/// Number of bits of F: as many as the ALU has processed, or those tested by an edge.
std::uint32_t wanted_f_bits(const PlainBeat& beat) {
  const Opcode opcode = beat.instruction.opcode;
  const std::uint32_t bits = std::uint32_t{beat.instruction.linear.width} - beat.instruction.linear.shift;
  const bool sums = opcode == Opcode::linear_plus || opcode == Opcode::linear_minus;
  return sums ? std::min<std::uint32_t>(bits, beat.instruction.fields[0].width) : bits;
}

}  // namespace

CellCheck::CellCheck(std::uint32_t cell, const scan_line::CellShape& shape, const machines::Machine& machine)
    : cell_(cell), shape_(shape), memory_bits_(machine.array.memory_bits), degree_(machine.evaluator_degree) {
  const std::uint32_t words = memory_bits_ / shape.word_bits;
  const std::uint32_t f_words = touched_words(isa::max_linear_width, shape.word_bits);
  const std::uint32_t short_words = std::min(words, touched_words(isa::max_field_width, shape.word_bits));
  f_bits_ = f_words * shape.word_bits;
  x_bits_ = std::min(words, f_words) * shape.word_bits;
  colour_bits_ = short_words * shape.word_bits;
}

std::string CellCheck::compare(const scan_line::Chain& chain, const test::PlainChain& plain, const PlainBeat& worked,
                               std::uint32_t pixels, const ChainRegisters& registers) {
  chain_ = &chain;
  plain_ = &plain;
  worked_ = &worked;
  registers_ = &registers;
  pixels_ = pixels;
  compare_state();
  compare_handed_on();
  compare_refresh();
  if (is_instruction(worked)) {
    compare_sum();
    compare_operands();
    compare_alu();
  }
  return std::exchange(difference_, {});
}

void CellCheck::expect(std::string_view what, Bits systemc, Bits verilog) {
  if (systemc != verilog && difference_.empty())
    difference_ = fmt::format("{} is {} in SystemC, {} in Verilog, beat {} of {}", what, show(systemc), show(verilog),
                              worked_->number, isa::name_of(worked_->instruction.opcode));
}

Bits CellCheck::of(const Vector& registers, std::uint32_t bits) const {
  Bits value = 0;
  const std::size_t first = std::size_t{cell_} * bits;
  for (std::uint32_t done = 0; done < bits; done += 64)
    value |= Bits{part_of(registers, first + done, std::min(bits - done, 64U))} << done;
  return value;
}

void CellCheck::compare_state() {
  is_cleared_ = is_cleared_ || (worked_->begins_line && worked_->number == 0) ||
                (worked_->kind == PacketKind::clear && worked_->last());
  if (!is_cleared_) return;
  expect("enable", chain_->enabled(cell_) ? 1 : 0, bit_of(registers_->enable) ? 1 : 0);
  if (worked_->kind == PacketKind::clear && !worked_->last()) return;  // the Verilog clears word by word
  for (std::uint32_t bit = 0; bit < memory_bits_; bit += isa::max_field_width) {
    const std::uint32_t bits = std::min(memory_bits_ - bit, isa::max_field_width);
    const std::uint64_t systemc =
        chain_->read(cell_, {static_cast<std::uint16_t>(bit), static_cast<std::uint16_t>(bits)});
    const std::uint64_t verilog = part_of(registers_->memory, std::size_t{cell_} * memory_bits_ + bit, bits);
    if (systemc != verilog) expect(fmt::format("memory from bit {} on", bit), systemc, verilog);
  }
}

void CellCheck::compare_handed_on() {
  if (cell_ + 1 == pixels_) return;
  const PlainBeat* const next = plain_->beat_in(cell_ + 1);
  if (next == nullptr || !brings_words(*next)) return;
  expect("the next cell's word of F", next->f, of(registers_->next_f, shape_.word_bits));
  expect("the next cell's word of A", next->a, of(registers_->next_a, shape_.word_bits));
  if (degree_ > 1) expect("the next cell's word of AA", next->aa, of(registers_->next_aa, shape_.word_bits));
}

void CellCheck::compare_refresh() {
  if (chain_->shifting(pixels_ - 1)) shown_ = held_;  // the shift chain has just latched the line
  if (worked_->kind == PacketKind::mark && worked_->last())
    held_ = worked_->background ? isa::Field{0, isa::max_field_width} : worked_->accesses.sources[0].field;
  if (held_) {
    const Bits held = low(of(registers_->held, colour_bits_) >> place_of(*held_), held_->width);
    expect("the colour held", chain_->held(cell_), held);
  }
  const std::optional<std::uint32_t> shifting = chain_->shifting(cell_);
  if (shifting && shown_)
    expect("the colour in the shift chain", *shifting,
           low(of(registers_->shifting, colour_bits_) >> place_of(*shown_), shown_->width));
}

void CellCheck::compare_sum() {
  if (!brings_words(*worked_)) return;
  const PlainCells& cells = plain_->cells();
  expect("the sum's carry", cells.carry(cell_) ? 1 : 0, bit_of(registers_->carry) ? 1 : 0);
  if (degree_ > 1)
    expect("the difference's carry", cells.difference_carry(cell_) ? 1 : 0,
           bit_of(registers_->difference_carry) ? 1 : 0);
  if (worked_->number >= worked_->accesses.work_from && move_clocks() > 0) return;
  const std::uint32_t dropped = worked_->instruction.linear.shift / shape_.word_bits;
  if (worked_->number < dropped) return;
  const std::uint32_t bits =
      std::min((worked_->number + 1 - dropped) * shape_.word_bits, 64 - dropped * shape_.word_bits);
  expect("F", low(Bits{cells.sum(cell_)} >> dropped * shape_.word_bits, bits), low(of(registers_->f, f_bits_), bits));
}

std::uint32_t CellCheck::worked_clocks() const {
  const scan_line::Accesses& accesses = worked_->accesses;
  if (worked_->number < accesses.work_from) return 0;
  return std::min(worked_->number, accesses.result) - accesses.work_from + 1;
}

std::uint32_t CellCheck::move_clocks() const {
  std::uint32_t clocks = 0;
  for (const Move& move : worked_->work.moves) clocks += move.words * quotient_up(move.distance, shape_.shift_bits);
  return clocks;
}

std::uint32_t CellCheck::taken() const {
  if (!is_moved()) return 0;
  const std::uint32_t bits = worked_->work.bits;
  return std::min(bits, (worked_clocks() - move_clocks()) * scan_line::alu_width(shape_, bits));
}

void CellCheck::compare_operands() {
  const PlainCells& cells = plain_->cells();
  const auto& [first, second] = worked_->accesses.sources;
  const bool has_work = worked_clocks() > 0;
  if (has_work && !is_moved()) return;
  const bool is_root = worked_->instruction.opcode == Opcode::root;
  const isa::Field met = worked_->instruction.fields[0];
  const bool moves = has_work && move_clocks() > 0;

  if (is_linear(*worked_) && has_work && worked_->work.bits > 0) {
    const std::uint64_t value = cells.sum(cell_) >> worked_->instruction.linear.shift;
    const std::uint32_t bits = wanted_f_bits(*worked_);
    expect("F in its place", low(value, bits), low(of(registers_->f, f_bits_) >> place_of(met), bits));
  }
  if (first.count > 0 && worked_->number < worked_->beats) {
    std::uint64_t expected = cells.fetched(cell_, 0);
    if (is_root && !has_work) expected &= (std::uint64_t{1} << (first.field.width - 1U)) - 1;
    const Bits place = moves ? place_of(met) : place_of(first.field);
    Bits actual = of(registers_->x, x_bits_) >> place;
    if (moves) actual = low(actual, first.field.width);
    if (stores(*worked_) && taken() > 0) {
      const std::uint64_t result = cells.alu(cell_).value();
      expect("the ALU's value", low(result, taken()), low(actual, taken()));
      expect("the rest of x", low(expected >> taken(), all_bits), low(actual, first.field.width) >> taken());
    } else {
      expect("x", expected, actual);
    }
  }
  if (second.count > 0) {
    const Bits place = moves ? place_of(met) : place_of(second.field);
    expect("y", cells.fetched(cell_, 1), of(registers_->y, x_bits_) >> place);
  }
}

void CellCheck::compare_alu() {
  const AluFunction function = worked_->work.function;
  const test::PlainAlu& alu = plain_->cells().alu(cell_);
  const auto flag = [&](std::string_view what, bool systemc, bool verilog) {
    expect(what, systemc ? 1 : 0, verilog ? 1 : 0);
  };
  if (taken() > 0) {
    flag("that operands are equal", alu.equal(), !bit_of(registers_->differs));
    if (function == AluFunction::subtract) flag("the borrow", alu.below(), !bit_of(registers_->alu_carry));
    if (function == AluFunction::add) flag("the ALU's carry", alu.below(), bit_of(registers_->alu_carry));
    if (taken() == worked_->work.bits && is_linear(*worked_) && !stores(*worked_)) {
      flag("that F is less", alu.less(), bit_of(registers_->negative_x) || bit_of(registers_->negative));
      flag("that F fits", alu.fits(), !bit_of(registers_->negative_x) && !bit_of(registers_->beyond));
    }
  }
  if (worked_->number >= worked_->accesses.result && worked_->accesses.target.count > 0)
    flag("that the result is written", plain_->cells().writes(cell_), bit_of(registers_->written));
}

}  // namespace csgsim::rtl
