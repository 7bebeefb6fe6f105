#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/array/column_bits.h"
#include "hw/array/sequencer.h"
#include "hw/isa/program.h"

namespace csgsim::bench {

/// The baseline of the clocked engine: a straightforward implementation of a frame buffer's processors. For each bit
/// step of each instruction, one loop over all words of the planes computes the trees' bit of every pixel, and another
/// executes the step of the ALU, with the widest vectors of the computer. No modules, links, tree registers or
/// counters, and no skipping of disabled pixels.
class DenseLoop {
 public:
  /// A bit-serial machine whose memory is read once per clock.
  explicit DenseLoop(const isa::ArrayShape& shape);

  /// Clears memory and registers, and executes the segment. Returns its number of bit steps.
  std::uint64_t run(const isa::Segment& segment);

  /// Whether the memory bit at `address` is 1 at a pixel of the segment.
  [[nodiscard]] bool memory_bit(std::uint32_t address, std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] bool enabled(std::uint32_t x, std::uint32_t y) const;

  /// 64 pixels per word; each row begins at a new word.
  using Plane = std::vector<std::uint64_t>;
  [[nodiscard]] const Plane& memory(std::uint32_t address) const { return memory_[address]; }

 private:
  std::uint64_t execute(const isa::Instruction& instruction);
  void tree_bit(const array::kernels::StreamTable& columns, unsigned bit);
  void crossed_bit(const array::Stream& stream, unsigned bit);
  void alu_step(const array::ArrayStep& step);
  [[nodiscard]] bool any_enabled() const;

  std::size_t row_words_;
  std::uint32_t height_;
  array::Sequencer sequencer_;
  std::vector<Plane> memory_;
  Plane present_;
  Plane enable_;
  Plane carry_;
  Plane flag_;
  Plane latch_;
  Plane tree_;
  Plane tree_carry_;  ///< carry of the adders that add the rows' part to the columns'
  array::ColumnBits columns_;
};

}  // namespace csgsim::bench
