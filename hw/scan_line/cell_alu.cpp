#include "hw/scan_line/cell_alu.h"

#include <algorithm>
#include <array>

namespace csgsim::scan_line {

namespace {

/// The low bits of a word are 1; `bits` is below 64.
constexpr std::uint64_t ones(std::uint32_t bits) { return (std::uint64_t{1} << bits) - 1; }

bool top_of(std::uint64_t value, std::uint32_t count) { return (value >> (count - 1) & 1U) != 0; }

}  // namespace

bool CellAlu::moves(const CellWork& work, const CellShape& cell) const {
  if (cell.shift_bits == 0) return false;
  return std::any_of(work.moves.begin() + static_cast<std::ptrdiff_t>(move_), work.moves.end(),
                     [](const Move& move) { return move.distance > 0; });
}

bool CellAlu::done(const CellWork& work, const CellShape& cell) const {
  return !moves(work, cell) && taken_ == work.bits;
}

void CellAlu::clock(const CellWork& work, const AluOperands& operands, const CellShape& cell) {
  if (moves(work, cell)) return move_on(work, cell);
  if (taken_ < work.bits) take(work, operands, std::min(alu_width(cell, work.bits), work.bits - taken_));
}

void CellAlu::move_on(const CellWork& work, const CellShape& cell) {
  while (work.moves.at(move_).distance == 0) ++move_;
  const Move& move = work.moves.at(move_);
  moved_ += cell.shift_bits;
  if (moved_ < move.distance) return;
  moved_ = 0;
  if (++word_ < move.words) return;
  word_ = 0;
  ++move_;
}

void CellAlu::take(const CellWork& work, const AluOperands& operands, std::uint32_t count) {
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

}  // namespace csgsim::scan_line
