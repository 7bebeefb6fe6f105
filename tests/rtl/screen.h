#pragma once

#include <cstdint>
#include <vector>

#include "tests/rtl/rtl_machine.h"

namespace csgsim::rtl {

/// Gathers the pixels that the Verilog shows into pictures.
class Screen {
 public:
  /// Of so many columns; pixels have so many wires.
  Screen(std::uint32_t width, std::uint32_t pixels, std::uint32_t colour_bits)
      : width_(width), pixels_(pixels), colour_bits_(colour_bits) {}

  /// What is shown in a clock.
  void show(const Outputs& outputs);

  /// The colours since the last first pixel of a picture, in row order.
  [[nodiscard]] const std::vector<std::uint32_t>& picture() const { return picture_; }

 private:
  std::uint32_t width_;
  std::uint32_t pixels_;  ///< a clock
  std::uint32_t colour_bits_;
  std::uint32_t column_ = 0;
  std::vector<std::uint32_t> picture_;
};

}  // namespace csgsim::rtl
