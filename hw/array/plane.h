// Bit planes: one 64-bit word holds one bit of 64 pixels.
// Used by hw/array, hw/pixel_planes, hw/pixel_square and hw/systemc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <vector>

namespace csgsim::array {

inline constexpr std::size_t word_bits = 64;        ///< pixels per word
inline constexpr std::size_t plane_alignment = 64;  ///< bytes; planes are padded to it, so kernels need no remainder

/// Allocates at cache line boundaries.
template <class T>
struct AlignedAllocator {
  using value_type = T;

  AlignedAllocator() = default;
  template <class U>
  explicit AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{plane_alignment}));
  }
  void deallocate(T* pointer, std::size_t /*count*/) { ::operator delete (pointer, std::align_val_t{plane_alignment}); }
  bool operator==(const AlignedAllocator&) const = default;
};

using Words = std::vector<std::uint64_t, AlignedAllocator<std::uint64_t>>;

constexpr std::size_t round_up(std::size_t value, std::size_t step) { return (value + step - 1) / step * step; }

/// Layout of one bit of every pixel: pixel x of a row is bit x % 64 of word x / 64; rows are padded to whole words, the
/// plane to whole cache lines.
struct PlaneShape {
  std::uint32_t width = 0;   ///< pixels
  std::uint32_t height = 0;  ///< pixels

  [[nodiscard]] constexpr std::size_t row_words() const { return (width + word_bits - 1) / word_bits; }
  [[nodiscard]] constexpr std::size_t words() const { return row_words() * height; }
  [[nodiscard]] constexpr std::size_t padded_words() const {
    return round_up(words(), plane_alignment / sizeof(std::uint64_t));
  }
  [[nodiscard]] constexpr std::size_t word_of(std::uint32_t x, std::uint32_t y) const {
    return y * row_words() + x / word_bits;
  }
  constexpr bool operator==(const PlaneShape&) const = default;
};

/// Position of a pixel in an array.
struct Place {
  std::uint32_t x = 0;
  std::uint32_t y = 0;

  constexpr bool operator==(const Place&) const = default;
};

inline bool bit_of(std::span<const std::uint64_t> plane, PlaneShape shape, std::uint32_t x, std::uint32_t y) {
  return ((plane[shape.word_of(x, y)] >> (x % word_bits)) & 1U) != 0;
}

/// A word whose low `bits` bits (0 to 64) are 1.
constexpr std::uint64_t low_bits(std::size_t bits) {
  return bits >= word_bits ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

}  // namespace csgsim::array
