#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"
#include "hw/pixel_planes/pixel_processors.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// A finished square, its header and its colours, which leaves in words of `port_bits`.
class OutputBuffer {
 public:
  explicit OutputBuffer(std::uint32_t port_bits) : port_bits_(port_bits) {}

  /// Takes the field of every pixel of the region, which the memory's corner holds.
  void load(const pixel_planes::RefreshPort& memory, isa::Field colour, const isa::Region& region);

  /// Some of the square has not left.
  [[nodiscard]] bool busy() const { return first_ < size_; }

  /// The word to leave next, while busy.
  [[nodiscard]] PortWord word() const { return {slice_of(bits_, first_, port_bits_)}; }

  /// It has left.
  void advance() { first_ += port_bits_; }

 private:
  std::uint32_t port_bits_;
  std::vector<std::uint32_t> colours_;
  std::vector<std::uint64_t> bits_;
  std::uint64_t first_ = 0;  ///< bit of the word to leave next
  std::uint64_t size_ = 0;   ///< bits of the square
};

}  // namespace csgsim::pixel_square
