#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// A finished square, its header and its colours, which leaves in words of `port_bits`. Its rows come in one by one, or
/// all at once.
class OutputBuffer {
 public:
  explicit OutputBuffer(std::uint32_t port_bits) : port_bits_(port_bits) {}

  /// Begins a square of so many bits of colour a pixel: no row is in.
  void begin(const isa::Region& region, std::uint32_t colour_bits);

  /// The next row comes in: the field of each of its pixels, which the memory's corner holds.
  void take_row(const pixel_planes::RefreshPort& memory, isa::Field colour);

  /// So do all rows.
  void load(const pixel_planes::RefreshPort& memory, isa::Field colour, const isa::Region& region);

  /// Some of the square has not left.
  [[nodiscard]] bool busy() const { return first_ < size_; }

  /// While busy: all of the word to leave next is in.
  [[nodiscard]] bool has_word() const { return first_ + port_bits_ <= filled_ || filled_ == size_; }

  /// Of the next word of colours something is not in.
  [[nodiscard]] bool wants_row() const;
  [[nodiscard]] PortWord word() const { return {slice_of(bits_, first_, port_bits_)}; }

  /// It has left.
  void advance() { first_ += port_bits_; }

 private:
  std::uint32_t port_bits_;
  isa::Region region_;
  std::vector<std::uint32_t> colours_;  ///< of a row
  std::vector<std::uint64_t> bits_;
  std::uint32_t rows_ = 0;    ///< that are in
  std::uint64_t first_ = 0;   ///< bit of the word to leave next
  std::uint64_t filled_ = 0;  ///< bits that are in
  std::uint64_t size_ = 0;    ///< bits of the square
};

}  // namespace csgsim::pixel_square
