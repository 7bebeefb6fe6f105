#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/scan_line/cell_kernels.h"
#include "hw/scan_line/cell_steps.h"
#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

using kernels::CellRange;

/// The cells of a chain or of a tree. Each has a memory of words with `ports` ports, an enable bit, a shifter, an ALU,
/// and registers: two fields that were read, the ALU's result, a field to write, and the value held for the refresh.
/// The memory can write single bits of a word. A root is computed by the ALU in the register of the first field. F
/// comes from the adders before the cell (arriving_words); their sums are computed from the coefficients.
///
/// Cells are independent of each other, so some may be simulated ahead of others. Each cell must execute all steps in
/// order.
class Cells {
 public:
  Cells(std::uint32_t count, std::uint32_t memory_bits);

  [[nodiscard]] std::uint32_t count() const { return count_; }

  /// Executes steps of the packet's beats in the cells of the range. Returns the number of cells that were enabled in
  /// the acting step.
  std::uint64_t execute(const Packet& packet, std::span<const CellStep> steps, CellRange range);

  /// Executes all steps of the packet. Cells whose memory, enable and hold register would not change may be omitted.
  std::uint64_t execute_all(const Packet& packet, std::span<const CellStep> steps, CellRange range);

  [[nodiscard]] bool enabled(std::uint32_t cell) const { return enable_[cell] != 0; }
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;
  /// Value that the cell holds for the refresh.
  [[nodiscard]] std::uint32_t held(std::uint32_t cell) const { return hold_[cell]; }

  /// For each enabled cell i of the range, sets bit i % 64 of words[i / 64].
  void add_enabled(CellRange range, std::span<std::uint64_t> words) const {
    kernels::add_bits(enable_.data(), range, words);
  }

  /// Number of 64-bit words of a cell's memory.
  [[nodiscard]] std::size_t cell_words() const { return cell_words_; }
  [[nodiscard]] std::uint64_t memory_word(std::uint32_t cell, std::size_t word) const {
    return memory_[word * stride_ + cell];
  }

 private:
  void clear(CellRange range);
  void hold(const Packet& mark, CellRange range);
  [[nodiscard]] kernels::Lanes lanes();
  [[nodiscard]] bool any_enabled(CellRange range) const;

  std::uint32_t count_;
  std::size_t stride_;
  std::size_t cell_words_;
  std::vector<std::uint64_t> memory_;
  std::vector<std::uint64_t> enable_;
  std::vector<std::uint64_t> fetched_;  ///< the first field of every cell, followed by the second field of every cell
  std::vector<std::uint64_t> value_;
  std::vector<std::uint64_t> flags_;
  std::vector<std::uint64_t> writes_;
  std::vector<std::uint32_t> hold_;
};

}  // namespace csgsim::scan_line
