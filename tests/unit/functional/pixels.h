#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/functional/lanes.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::testing {

/// Uniform in [low, end) for any size of a test case.
template <class Number>
Number between(Number low, Number end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Number>(low, end));
}

/// 64 bits: none, all, few, or half of them set.
std::uint64_t any_word();

/// 1 to tile_side pixels in each direction: whole tiles, whole blocks, and parts of them.
functional::TileShape any_shape();

/// A value for every pixel of a tile: the reference for the bits and lanes of sim/functional.
template <class Value>
class Pixels {
 public:
  explicit Pixels(const functional::TileShape& shape) : shape_(shape), values_(shape.area()) {}

  [[nodiscard]] Value at(std::uint32_t x, std::uint32_t y) const {
    return values_[std::size_t{y} * shape_.width() + x];
  }
  void set(std::uint32_t x, std::uint32_t y, Value value) { values_[std::size_t{y} * shape_.width() + x] = value; }

  /// Calls visit(x, y) for every pixel.
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::uint32_t y = 0; y < shape_.height(); ++y)
      for (std::uint32_t x = 0; x < shape_.width(); ++x) visit(x, y);
  }
  /// Sets every pixel to value(x, y).
  template <class Make>
  void set_each(const Make& value) {
    each([&](std::uint32_t x, std::uint32_t y) { set(x, y, value(x, y)); });
  }

  bool operator==(const Pixels& other) const { return values_ == other.values_; }

 private:
  functional::TileShape shape_;
  std::vector<Value> values_;
};

using Bits = Pixels<char>;
using Numbers = Pixels<std::uint32_t>;

/// Reads the bits individually. Asserts that bits outside the tile are 0 and that blocks are classified correctly.
Bits bits_of(const functional::TileBits& bits, const functional::TileShape& shape);

/// Sets blocks to all zeros, all ones, or random words. Returns the expected contents.
Bits set_random(functional::TileBits& bits, const functional::TileShape& shape);

/// Reads the numbers individually. Asserts that each is within its block's bounds.
Numbers numbers_of(const functional::Lanes& lanes, const functional::TileShape& shape);

/// Sets blocks to a constant or to a few random values of `bits` bits, including the minimum and the maximum. Returns
/// the expected contents.
Numbers set_random(functional::Lanes& lanes, unsigned bits, const functional::TileShape& shape);

}  // namespace csgsim::testing
