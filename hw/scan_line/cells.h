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

/// The cells of a chain, or below a tree. Each has a memory of words with so many ports, an enable bit, a shifter, an
/// ALU, and registers: two fields that have been read, what the ALU has made of them, a field to be written, and what
/// is held for the refresh. The memory writes single bits of a word. A root is taken by the ALU, in the register of the
/// first field read. F comes from the adders before the cell (words_in), whose sums follow from the coefficients.
///
/// Cells do not depend on each other, so any may be ahead of others; each has to be given all steps in order.
class Cells {
 public:
  Cells(std::uint32_t count, std::uint32_t memory_bits);

  [[nodiscard]] std::uint32_t count() const { return count_; }

  /// These cells carry out the steps, of the packet's beats. Returns how many of them were enabled when they acted.
  std::uint64_t carry_out(const Packet& packet, std::span<const CellStep> steps, CellRange range);

  /// Likewise all steps of the packet; cells in which that leaves memory, enable and hold register as they are need not
  /// carry them out.
  std::uint64_t carry_out_all(const Packet& packet, std::span<const CellStep> steps, CellRange range);

  [[nodiscard]] bool enabled(std::uint32_t cell) const { return enable_[cell] != 0; }
  [[nodiscard]] std::uint64_t read(std::uint32_t cell, isa::Field field) const;
  /// What the cell holds for the refresh.
  [[nodiscard]] std::uint32_t held(std::uint32_t cell) const { return hold_[cell]; }

  /// Sets the enable bits of the range in words of 64 cells.
  void add_enabled(CellRange range, std::span<std::uint64_t> words) const {
    kernels::add_bits(enable_.data(), range, words);
  }

  /// 64-bit words of a cell's memory.
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
  std::vector<std::uint64_t> fetched_;  ///< the first of every cell, then the second
  std::vector<std::uint64_t> value_;
  std::vector<std::uint64_t> flags_;
  std::vector<std::uint64_t> writes_;
  std::vector<std::uint32_t> hold_;
};

}  // namespace csgsim::scan_line
