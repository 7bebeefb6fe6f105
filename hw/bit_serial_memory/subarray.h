#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/row_map.h"

namespace csgsim::bit_serial_memory {

using RowWords = std::vector<std::uint64_t>;

/// Writes one bit of the expression for every column to `words`.
using LeafBits = std::function<void(unsigned bit, std::span<std::uint64_t> words)>;

/// The rows of a subarray, or of several that work in lockstep, and the latches at their sense amplifiers: column c is
/// bit c % 64 of word c / 64.
class Subarray {
 public:
  Subarray(const RowMap& map, std::uint32_t columns);

  /// Executes a command. `leaves` supplies the expression's bits, for commands that use them.
  void execute(const RowCommand& command, const LeafBits& leaves);

  [[nodiscard]] std::span<const std::uint64_t> row(Row row) const { return rows_[row]; }
  [[nodiscard]] std::span<const std::uint64_t> latch(Latch latch) const {
    return latches_[static_cast<std::size_t>(latch)];
  }
  /// Data at the sense amplifiers, from the last command that opened a row.
  [[nodiscard]] std::span<const std::uint64_t> sent() const { return latch(Latch::sense); }
  void set_row(Row row, std::span<const std::uint64_t> words);

  [[nodiscard]] std::uint32_t columns() const { return columns_; }
  [[nodiscard]] std::size_t words() const { return rows_.front().size(); }

 private:
  [[nodiscard]] RowWords& latch_words(Latch latch) { return latches_[static_cast<std::size_t>(latch)]; }
  void sense(const WordLines& lines);
  void drive(const RowCommand& command);
  void carry_out_gate(const RowCommand& command);

  std::uint32_t columns_;
  std::vector<RowWords> rows_;
  std::array<RowWords, latch_count> latches_;
};

}  // namespace csgsim::bit_serial_memory
