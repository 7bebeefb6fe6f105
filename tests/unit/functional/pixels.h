#pragma once

#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/functional/bit_plane.h"

namespace csgsim::testing {

/// In [low, end), all as likely at any size of a case.
template <class Number>
Number between(Number low, Number end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Number>(low, end));
}

/// 64 bits of any kind: none, all, few, or as many of one as of the other.
std::uint64_t any_word();

/// A bit of every pixel, one by one: what the planes of sim/functional are held against.
class Pixels {
 public:
  Pixels(std::uint32_t width, std::uint32_t height)
      : width_(width), height_(height), bits_(static_cast<std::size_t>(width) * height) {}

  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] std::uint32_t height() const { return height_; }
  [[nodiscard]] bool at(std::uint32_t x, std::uint32_t y) const { return bits_[std::size_t{y} * width_ + x]; }
  void set(std::uint32_t x, std::uint32_t y, bool bit) { bits_[std::size_t{y} * width_ + x] = bit; }

  /// bit := value(x, y), at every pixel.
  template <class Value>
  void set_each(const Value& value) {
    for (std::uint32_t y = 0; y < height_; ++y)
      for (std::uint32_t x = 0; x < width_; ++x) set(x, y, value(x, y));
  }

  [[nodiscard]] std::uint64_t ones() const;
  /// The smallest rectangle around the ones.
  [[nodiscard]] sim::Rect bounds() const;

  bool operator==(const Pixels&) const = default;

 private:
  std::uint32_t width_;
  std::uint32_t height_;
  std::vector<bool> bits_;
};

bool holds(const sim::Rect& rect, std::uint32_t x, std::uint32_t y);

/// The plane's bits, one by one. Asserts that those past a row's end, where there are no pixels, are 0.
Pixels pixels_of(const sim::BitPlane& plane);

/// All 0. One pixel wide, or a part of a word, just a word, a bit more than one or two, or anything in between.
Pixels any_size();

/// A rectangle within another one, perhaps an empty one.
sim::Rect any_rect(const sim::Rect& within);

/// The plane becomes a solid rectangle, or words of any kind within one. Returns what it has to hold then.
Pixels set_any(sim::BitPlane& plane);

}  // namespace csgsim::testing
