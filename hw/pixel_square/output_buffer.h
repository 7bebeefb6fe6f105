#pragma once

#include <cstdint>
#include <vector>

#include "hw/array/pixel_array.h"
#include "hw/pixel_square/words.h"

namespace csgsim::pixel_square {

/// The colours of a finished square, which leave it in words of `port_bits`. Without colours a square is one empty
/// word, which tells of its end.
class OutputBuffer {
 public:
  explicit OutputBuffer(std::uint32_t port_bits) : port_bits_(port_bits) {}

  /// Takes the field of every pixel of the region, which the array's corner holds, all at once.
  void load(const array::PixelArray& pixels, isa::Field colour, const isa::Region& region);

  /// Some of the square has not left.
  [[nodiscard]] bool busy() const { return busy_; }

  /// The word to leave next, while busy.
  [[nodiscard]] ColourWord word() const;

  /// It has left.
  void advance();

 private:
  [[nodiscard]] bool bit(std::uint64_t index) const { return (bits_[index / 64] >> (index % 64) & 1U) != 0; }
  [[nodiscard]] std::uint64_t left() const { return size_ - first_; }

  std::uint32_t port_bits_;
  isa::Region region_;
  std::vector<std::uint32_t> colours_;
  std::vector<std::uint64_t> bits_;
  std::uint64_t size_ = 0;   ///< colour bits of the square
  std::uint64_t first_ = 0;  ///< that has not left
  bool busy_ = false;
};

}  // namespace csgsim::pixel_square
