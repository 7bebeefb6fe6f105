#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "hw/isa/program.h"

/// Expected squares and roots, computed in 128-bit integers and with methods different from those of the engines.
namespace csgsim::test {

__extension__ using Wide = __int128;

/// The sum A*x*x + B*x*y + C*y*y + a*x + b*y + c of squares and a linear expression.
struct Quadratic {
  isa::Linear squares;
  isa::Linear linear;

  [[nodiscard]] Wide sum(Wide x, Wide y) const {
    return squares.a * x * x + squares.b * x * y + squares.c * y * y + linear.a * x + linear.b * y + linear.c;
  }
  /// The low `width` bits in two's complement.
  [[nodiscard]] Wide kept(Wide x, Wide y) const {
    const Wide period = static_cast<Wide>(1) << linear.width;
    const Wide low = (sum(x, y) % period + period) % period;
    return low >= period / 2 ? low - period : low;
  }
  [[nodiscard]] bool fits(Wide x, Wide y) const { return sum(x, y) == kept(x, y); }
  [[nodiscard]] std::int64_t f(Wide x, Wide y) const {
    const Wide step = static_cast<Wide>(1) << linear.shift;
    const Wide number = kept(x, y);
    return static_cast<std::int64_t>(number / step - (number % step < 0 ? 1 : 0));
  }
};

constexpr std::uint64_t below_bits(std::int64_t number, unsigned width) {
  return static_cast<std::uint64_t>(number) & ((std::uint64_t{1} << width) - 1);
}

/// Valid expression over a segment of the given shape: sometimes flat, sometimes steep, often near 0 at some pixel, and
/// sometimes too large for its width.
inline Quadratic any_quadratic(isa::ArrayShape shape) {
  const auto between = [](std::int64_t least, std::int64_t most) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(least, most + 1));
  };
  const auto up_to = [&](std::int64_t most) {
    return *rc::gen::element<std::int64_t>(0, most, -most, between(-most, most), between(-most, most));
  };
  const std::int64_t w = shape.width;
  const std::int64_t h = shape.height;
  Quadratic one;
  const auto width = static_cast<std::uint16_t>(between(2, isa::max_linear_width));
  const auto shift = static_cast<std::uint16_t>(between(0, std::min(12, width - 2)));
  const auto reach = std::min<std::int64_t>(width - 1 + between(-3, 2), 59);
  const std::int64_t share = (std::int64_t{1} << std::max<std::int64_t>(reach, 0)) / 6;
  one.squares = {up_to(share / w / w), up_to(share / w / h), up_to(share / h / h), width, 0};
  one.linear = {up_to(share / w), up_to(share / h), 0, width, shift};
  one.linear.c = up_to(share) - static_cast<std::int64_t>(one.sum(between(0, w - 1), between(0, h - 1)));
  return one;
}

/// Reproducible pseudo-random bits.
constexpr std::uint64_t mixed_bits(std::uint64_t number, unsigned width) {
  std::uint64_t bits = (number + 1) * 0x9e3779b97f4a7c15U;
  bits = (bits ^ bits >> 30U) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ bits >> 27U) * 0x94d049bb133111ebU;
  return (bits ^ bits >> 31U) & ((std::uint64_t{1} << width) - 1);
}

/// Radicands D of 2w bits, with and without a bit above them: ends of the range, squares and their neighbours.
inline std::vector<std::uint64_t> extreme_squares(unsigned w) {
  const std::uint64_t most = (std::uint64_t{1} << w) - 1;
  const std::uint64_t all = (std::uint64_t{1} << 2 * w) - 1;
  std::vector<std::uint64_t> squares{0, 1, 2, 3, all, all - 1, all / 2, all / 2 + 1};
  for (const std::uint64_t root : {most, most - most / 2, most / 3 + 1, std::uint64_t{1}})
    for (const std::uint64_t beside : {root * root - 1, root * root, root * root + 1, root * (root + 1)})
      squares.push_back(std::min(beside, all));
  for (std::size_t i = squares.size(); i-- > 0;) squares.push_back(squares[i] | (std::uint64_t{1} << 2 * w));
  return squares;
}

/// Expected field of 2w + 1 bits after the instruction; computes the root by Newton's iteration from above.
inline std::uint64_t root_field(std::uint64_t field, unsigned w) {
  const std::uint64_t square = field & ((std::uint64_t{1} << 2 * w) - 1);
  std::uint64_t root = std::uint64_t{1} << w;
  for (std::uint64_t next = root; square != 0; root = next) {
    next = (root + square / root) / 2;
    if (next >= root) break;
  }
  if (square == 0) root = 0;
  const Wide odd = static_cast<Wide>(root) | 1;
  const Wide period = static_cast<Wide>(2) << w;
  const Wide left = ((static_cast<Wide>(square) - odd * odd) % period + period) % period;
  return static_cast<std::uint64_t>(static_cast<Wide>(root) * period + left);
}

}  // namespace csgsim::test
