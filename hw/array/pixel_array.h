#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/array_step.h"
#include "hw/array/plane.h"
#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::array {

/// The state of one pixel processor besides its memory.
struct PixelProbe {
  bool tree = false;
  bool carry = false;
  bool enable = false;
  std::uint32_t latch = 0;  ///< a bit a bit of the ALU
};

/// The pixel processors and memories of the whole array: each register and each memory bit is a plane.
class PixelArray {
 public:
  /// `alu_bits`: most bits that a step may work on.
  PixelArray(const isa::ArrayShape& shape, unsigned alu_bits);

  [[nodiscard]] const PlaneShape& shape() const { return shape_; }
  [[nodiscard]] std::uint32_t memory_bits() const { return static_cast<std::uint32_t>(memory_.size()); }

  /// Clears memory and registers, and selects.
  void reset(std::uint32_t width, std::uint32_t height);

  /// Clears so many memory bits of every pixel, from that address on.
  void clear_memory(std::uint32_t address, std::uint32_t bits);

  /// Clears the registers. Pixels right of `width` or below `height` take no part until the next select: their enable
  /// bits stay 0.
  void select(std::uint32_t width, std::uint32_t height);

  /// One clock of all pixels; `tree` are the leaves of the multiplier trees (shape().padded_words() words).
  void step(const ArrayStep& step, std::span<const std::uint64_t> tree);

  [[nodiscard]] bool any_enabled() const;
  [[nodiscard]] std::uint64_t count_enabled() const;

  [[nodiscard]] std::span<const std::uint64_t> enable() const { return enable_; }
  [[nodiscard]] std::span<const std::uint64_t> memory(std::uint32_t address) const { return memory_[address]; }

  /// One memory bit of one row.
  [[nodiscard]] std::span<const std::uint64_t> memory_row(std::uint32_t address, std::uint32_t row) const {
    return std::span<const std::uint64_t>(memory_[address]).subspan(row * shape_.row_words(), shape_.row_words());
  }

  /// The field's values in a `width` x `height` corner of the array, in row order.
  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height, std::span<std::uint32_t> values) const;

  /// `tree`: as in step.
  [[nodiscard]] PixelProbe probe(std::uint32_t x, std::uint32_t y, std::span<const std::uint64_t> tree) const;
  [[nodiscard]] bool memory_bit(std::uint32_t address, std::uint32_t x, std::uint32_t y) const {
    return bit_of(memory_[address], shape_, x, y);
  }

 private:
  void bit_step(const ArrayStep& step, unsigned bit, std::span<const std::uint64_t> tree);

  PlaneShape shape_;
  std::vector<Words> memory_;
  Words enable_;
  Words carry_;
  std::vector<Words> latch_;
  Words present_;
};

}  // namespace csgsim::array
