#pragma once

#include <cstdint>
#include <vector>

#include "hw/array/array_step.h"
#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

namespace csgsim::test {

/// Operands and registers of one pixel in a clock that processes one bit.
struct PixelState {
  bool x = false;
  bool y = false;
  bool present = false;
  bool enable = false;
  bool carry = false;
  bool latch = false;
  bool flag = false;
  bool memory = false;  ///< bit at the write address

  bool operator==(const PixelState&) const = default;
};

/// The state that follows `state`, according to the table of ALU functions.
PixelState next_state(array::AluFunction function, bool constant, PixelState state);

/// Reference pixel processors: each is a struct of bools, and every step is executed immediately, pixel by pixel.
class PlainArray {
 public:
  PlainArray(array::PlaneShape shape, std::uint32_t memory_bits, unsigned alu_bits);

  struct Pixel {
    bool present = true;
    bool enable = false;
    bool carry = false;
    bool flag = false;
    std::vector<bool> latch;
    std::vector<bool> memory;
  };

  [[nodiscard]] const Pixel& at(std::uint32_t x, std::uint32_t y) const {
    return pixels_[std::size_t{y} * shape_.width + x];
  }

  // Same meaning as the functions of array::PixelArray.
  void clear_memory(std::uint32_t address, std::uint32_t bits);
  void select_pixels(std::uint32_t width, std::uint32_t height);
  void step(const array::ArrayStep& step, const array::StreamBit& tree);

 private:
  static void execute_step(const array::ArrayStep& step, std::uint32_t leaves, Pixel& pixel);

  array::PlaneShape shape_;
  std::vector<Pixel> pixels_;
};

}  // namespace csgsim::test
