#include "hw/bit_serial_memory/subarray.h"

#include <algorithm>
#include <cstddef>

namespace csgsim::bit_serial_memory {

Subarray::Subarray(const RowMap& map, std::uint32_t columns) : columns_(columns) {
  const std::size_t words = (columns + 63) / 64;
  rows_.assign(map.rows(), RowWords(words));
  latches_.fill(RowWords(words));
  std::ranges::fill(rows_[map.one()], ~std::uint64_t{0});
}

void Subarray::set_row(Row row, std::span<const std::uint64_t> words) { std::ranges::copy(words, rows_[row].begin()); }

/// Copies the value on the bit lines, a row or the majority of three rows, to `sense`; three rows are overwritten with
/// their majority.
void Subarray::sense(const WordLines& lines) {
  RowWords& sensed = latch_words(Latch::sense);
  for (std::size_t word = 0; word < sensed.size(); ++word) {
    std::array<std::uint64_t, 3> bits{};
    for (std::size_t i = 0; i < lines.count; ++i) {
      const std::uint64_t stored = rows_[lines.lines[i].row][word];
      bits[i] = lines.lines[i].negated ? ~stored : stored;
    }
    sensed[word] = lines.count == 1 ? bits[0] : (bits[0] & bits[1]) | (bits[2] & (bits[0] | bits[1]));
    if (lines.count == 1) continue;
    for (const WordLine& line : lines) rows_[line.row][word] = line.negated ? ~sensed[word] : sensed[word];
  }
}

/// Writes the content of `sense` to the rows.
void Subarray::drive(const RowCommand& command) {
  const RowWords& sensed = latch_words(Latch::sense);
  for (const WordLine& line : command.to) {
    RowWords& target = rows_[line.row];
    for (std::size_t word = 0; word < sensed.size(); ++word) {
      const std::uint64_t value = line.negated ? ~sensed[word] : sensed[word];
      const std::uint64_t where = command.masked ? latch_words(command.mask)[word] : ~std::uint64_t{0};
      target[word] = (value & where) | (target[word] & ~where);
    }
  }
}

namespace {

std::uint64_t gate_of(Gate gate, std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  switch (gate) {
    case Gate::zero: return 0;
    case Gate::one: return ~std::uint64_t{0};
    case Gate::move: return x;
    case Gate::invert: return ~x;
    case Gate::conjunction: return x & y;
    case Gate::disjunction: return x | y;
    case Gate::unequal: return x ^ y;
    case Gate::equal: return ~(x ^ y);
    case Gate::choose: return (x & y) | (~x & z);
  }
  return 0;
}

}  // namespace

void Subarray::carry_out_gate(const RowCommand& command) {
  RowWords& target = latch_words(command.target);
  const RowWords& x = latch_words(command.x);
  const RowWords& y = latch_words(command.y);
  const RowWords& z = latch_words(command.z);
  for (std::size_t word = 0; word < target.size(); ++word)
    target[word] = gate_of(command.gate, x[word], y[word], z[word]);
}

void Subarray::execute(const RowCommand& command, const LeafBits& leaves) {
  switch (command.op) {
    case RowOp::copy: sense(command.from); return drive(command);
    case RowOp::activate:
    case RowOp::read:
    case RowOp::send: return sense(command.from);
    case RowOp::latch:
      sense(command.from);
      latch_words(Latch::enable) = latch_words(Latch::sense);
      return;
    case RowOp::write: return drive(command);
    case RowOp::logic: return carry_out_gate(command);
    case RowOp::leaf: return leaves(command.bit, latch_words(Latch::sense));
    case RowOp::leaf_copy:
    case RowOp::receive: leaves(command.bit, latch_words(Latch::sense)); return drive(command);
    case RowOp::wired_or: return;
  }
}

}  // namespace csgsim::bit_serial_memory
