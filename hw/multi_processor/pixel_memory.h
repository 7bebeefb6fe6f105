#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/base/quotient.h"
#include "hw/isa/instruction.h"
#include "hw/systemc/field_bits.h"

namespace csgsim::multi_processor {

/// Memory and enable bits of a set of pixels.
class PixelMemory {
 public:
  PixelMemory() = default;
  /// All bits are 0.
  PixelMemory(std::uint64_t pixels, std::uint32_t memory_bits)
      : pixel_words_(quotient_up(memory_bits, 64U)), memory_(pixels * pixel_words_), enable_(pixels) {}

  [[nodiscard]] std::size_t pixels() const { return enable_.size(); }

  [[nodiscard]] bool enabled(std::size_t pixel) const { return enable_[pixel] != 0; }
  void enable(std::size_t pixel, bool value) { enable_[pixel] = value ? 1 : 0; }

  /// The value of a field of the pixel; 0 for a field of width 0.
  [[nodiscard]] std::uint64_t read(std::size_t pixel, isa::Field field) const {
    return systemc::read_field(std::span(memory_).subspan(pixel * pixel_words_, pixel_words_), field);
  }

  /// Returns a copy of one pixel.
  [[nodiscard]] PixelMemory of(std::size_t pixel) const {
    PixelMemory one;
    one.pixel_words_ = pixel_words_;
    const auto first = memory_.begin() + static_cast<std::ptrdiff_t>(pixel * pixel_words_);
    one.memory_.assign(first, first + static_cast<std::ptrdiff_t>(pixel_words_));
    one.enable_ = {enable_[pixel]};
    return one;
  }

  /// Copies one pixel from `source`, a memory of equal shape.
  void copy(std::size_t pixel, const PixelMemory& source) {
    for (std::size_t i = 0; i < pixel_words_; ++i) {
      memory_[pixel * pixel_words_ + i] = source.memory_[pixel * pixel_words_ + i];
    }
    enable_[pixel] = source.enable_[pixel];
  }

  /// Writes the low bits of `value` to the field.
  void write(std::size_t pixel, isa::Field field, std::uint64_t value) {
    systemc::write_field(std::span(memory_).subspan(pixel * pixel_words_, pixel_words_), field, value);
  }

 private:
  std::size_t pixel_words_ = 0;
  std::vector<std::uint64_t> memory_;
  std::vector<std::uint8_t> enable_;
};

}  // namespace csgsim::multi_processor
