#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// A finished square, header and colours, that is sent in words of `port_bits` bits. Its rows are loaded one by one, or
/// all at once.
class OutputBuffer {
 public:
  explicit OutputBuffer(std::uint32_t port_bits) : port_bits_(port_bits) {}

  /// Begins a square with `colour_bits` bits of colour per pixel; no row is loaded.
  void begin(const isa::Region& region, std::uint32_t colour_bits);

  /// Loads the next row: the field `colour` of each of its pixels. The square is at the top left corner of the array.
  void load_row(const pixel_planes::RefreshPort& memory, isa::Field colour);

  /// Begins a square and loads all its rows.
  void load(const pixel_planes::RefreshPort& memory, isa::Field colour, const isa::Region& region);

  /// Whether part of the square has not been sent.
  [[nodiscard]] bool busy() const { return first_ < size_; }

  /// Whether all bits of the next word are loaded; valid only if busy().
  [[nodiscard]] bool has_word() const { return first_ + port_bits_ <= filled_ || filled_ == size_; }

  /// Whether some bits of the next word of colours are not loaded.
  [[nodiscard]] bool needs_row() const;
  [[nodiscard]] PortWord word() const { return {slice_of(bits_, first_, port_bits_)}; }

  /// Advances past the word that has been sent.
  void advance() { first_ += port_bits_; }

 private:
  std::uint32_t port_bits_;
  isa::Region region_;
  std::vector<std::uint32_t> colours_;  ///< colours of one row
  std::vector<std::uint64_t> bits_;
  std::uint32_t rows_ = 0;    ///< rows loaded
  std::uint64_t first_ = 0;   ///< first bit of the next word
  std::uint64_t filled_ = 0;  ///< bits loaded
  std::uint64_t size_ = 0;    ///< bits of the square
};

}  // namespace csgsim::pixel_square
