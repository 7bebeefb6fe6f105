// Pixel processors and memories of an array.
// Used by hw/pixel_planes, hw/systemc and PixelReplay.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/array_step.h"
#include "hw/array/deferred_pixels.h"
#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"
#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::array {

/// Registers of one pixel processor.
struct PixelProbe {
  std::uint32_t tree = 0;  ///< bits from the trees, the first lowest
  bool carry = false;
  bool enable = false;
  bool flag = false;
  std::uint32_t latch = 0;  ///< one bit per ALU bit
};

/// The pixel processors and memories of the whole array. Steps are deferred; reads force pending steps to complete.
class PixelArray {
 public:
  /// `alu_bits`: maximum number of bits that a step processes.
  PixelArray(const isa::ArrayShape& shape, unsigned alu_bits);

  /// Simulates only the given pixels of an array, side by side in a row, with the behaviour that they have in the whole
  /// array.
  PixelArray(std::span<const Place> pixels, std::uint32_t memory_bits, unsigned alu_bits);

  [[nodiscard]] const PlaneShape& shape() const { return shape_; }
  [[nodiscard]] std::uint32_t memory_bits() const { return pixels_.bits().memory_bits; }

  /// Clears memory and registers, then calls select_pixels().
  void reset(std::uint32_t width, std::uint32_t height);

  /// Clears `bits` memory bits of every pixel, starting at `address`.
  void clear_memory(std::uint32_t address, std::uint32_t bits);

  /// Clears the registers. Pixels right of `width` or below `height` take no part until the next select_pixels(): they
  /// stay disabled.
  void select_pixels(std::uint32_t width, std::uint32_t height);

  /// Executes one clock of all pixels. `tree` holds the bits at the leaves of the multiplier trees.
  void step(const ArrayStep& step, const StreamBit& tree);

  /// Executes one clock of all pixels. `tree` holds the tree bits of all pixels: one plane in the format of enable()
  /// for each bit that the trees deliver per clock. The number of planes must be the same in all calls.
  void step_with_planes(std::span<const std::uint64_t> tree, const ArrayStep& step);

  [[nodiscard]] bool any_enabled() const;
  [[nodiscard]] std::uint64_t count_enabled() const;

  /// Enable bits as a plane, valid until the next change.
  [[nodiscard]] std::span<const std::uint64_t> enable() const;

  /// One memory bit of every pixel.
  [[nodiscard]] Words memory(std::uint32_t address) const;

  /// Reads one memory bit of one row into `words`, which has shape().row_words() words.
  void read_row(std::uint32_t address, std::uint32_t row, std::span<std::uint64_t> words) const;

  /// Reads the field in the top left `width` x `height` corner of the array into `values`, in row order.
  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height, std::span<std::uint32_t> values) const;

  /// Registers and memory of one pixel. `tree`: as in step().
  [[nodiscard]] PixelProbe probe(std::uint32_t x, std::uint32_t y, const StreamBit& tree) const;
  [[nodiscard]] bool memory_bit(std::uint32_t address, std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] std::uint64_t value(isa::Field field, std::uint32_t x, std::uint32_t y) const;

 private:
  [[nodiscard]] std::uint64_t eight_pixels(isa::Field field, std::uint32_t x, std::uint32_t y) const;

  PlaneShape shape_;
  std::vector<Place> places_;      ///< positions of the pixels in the whole array; empty if all are built
  mutable DeferredPixels pixels_;  ///< mutable: reads settle pending steps
};

}  // namespace csgsim::array
