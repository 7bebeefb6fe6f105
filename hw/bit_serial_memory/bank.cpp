#include "hw/bit_serial_memory/bank.h"

namespace csgsim::bit_serial_memory {

Bank::Bank(sc_core::sc_module_name name, std::uint32_t number, const Slots& slots, const RowMap& map,
           std::uint32_t picture_width)
    : sc_core::sc_module(name), number_(number), slots_(slots) {
  for (std::uint64_t slot = number; slot < slots.count(); slot += slots.banks) {
    Subarray& subarray = subarrays_.emplace_back(map, static_cast<std::uint32_t>(slots.columns(slot)));
    write_coordinates(subarray, slot, map, picture_width);
  }
}

/// Writes the coordinates, which the machine's rows hold from the start.
void Bank::write_coordinates(Subarray& subarray, std::uint64_t slot, const RowMap& map,
                             std::uint32_t picture_width) const {
  const auto write = [&](unsigned bits, auto row_of, auto coordinate_of) {
    for (unsigned bit = 0; bit < bits; ++bit) {
      RowWords words(subarray.words());
      for (std::uint64_t column = 0; column < slots_.columns(slot); ++column) {
        const std::uint64_t coordinate = coordinate_of(slot * slots_.row_columns + column);
        words[column / 64] |= (coordinate >> bit & 1U) << column % 64;
      }
      subarray.set_row(row_of(bit), words);
    }
  };
  write(
      map.x_bits, [&](unsigned bit) { return map.x(bit); }, [&](std::uint64_t pixel) { return pixel % picture_width; });
  write(
      map.y_bits, [&](unsigned bit) { return map.y(bit); }, [&](std::uint64_t pixel) { return pixel / picture_width; });
}

void Bank::execute(const RowCommand& command, std::uint64_t slot) {
  subarrays_[slot / slots_.banks].execute(
      command, [&](unsigned bit, std::span<std::uint64_t> words) { expression->bits(slot, bit, words); });
}

void Bank::carry_out(const RowCommand& command, std::uint64_t slot, const sc_core::sc_time& until) {
  execute(command, slot);
  free_ = until;
  const auto raise = [&](const WordLines& lines) {
    ++work_.activations;
    if (lines.count > 1) work_.further_rows += lines.count - 1U;
  };
  if (command.from.count > 0) raise(command.from);
  if (command.to.count > 0) raise(command.to);
  if (command.op == RowOp::leaf_copy) ++work_.leaves;
  if (command.op == RowOp::receive || command.op == RowOp::send) work_.transferred_bits += slots_.columns(slot);
}

void Bank::carry_out_in_all(const RowCommand& command, const sc_core::sc_time& duration) {
  for (std::size_t i = 0; i < subarrays_.size(); ++i) execute(command, number_ + i * slots_.banks);
  free_ += duration;
  if (command.op == RowOp::logic) work_.logic += subarrays_.size();
  if (command.op == RowOp::leaf) work_.leaves += subarrays_.size();
}

}  // namespace csgsim::bit_serial_memory
