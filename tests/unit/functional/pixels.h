#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/functional/lanes.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::testing {

/// In [low, end), all as likely at any size of a case.
template <class Number>
Number between(Number low, Number end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Number>(low, end));
}

/// 64 bits of any kind: none, all, few, or as many of one as of the other.
std::uint64_t any_word();

/// 1 to tile_side pixels each way: whole tiles, whole blocks, parts of them.
functional::TileShape any_shape();

/// A value of every pixel of a tile, one by one: what the bits and lanes of sim/functional are held against.
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
  /// value := value(x, y), at every pixel.
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

/// The bits, one by one. Asserts that those where there is no pixel are 0, and that blocks are known for what they are.
Bits bits_of(const functional::TileBits& bits, const functional::TileShape& shape);

/// Blocks become all zeros, all ones, or words of any kind. Returns what they have to hold then.
Bits set_any(functional::TileBits& bits, const functional::TileShape& shape);

/// The numbers, one by one. Asserts that each is within its block's bounds.
Numbers numbers_of(const functional::Lanes& lanes, const functional::TileShape& shape);

/// Blocks become constant, or any few values of so many bits, the least and the greatest among them. Returns what they
/// have to hold then.
Numbers set_any(functional::Lanes& lanes, unsigned bits, const functional::TileShape& shape);

}  // namespace csgsim::testing
