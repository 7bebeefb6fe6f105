#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace csgsim::software {

__extension__ using Long = __int128;
__extension__ using UnsignedLong = unsigned __int128;

/// A whole number of 448 bits, two's complement: enough for a determinant of four planes (WholePlanes), which takes
/// 413.
class Wide {
 public:
  Wide() = default;

  /// Exact.
  static Wide product(Long one, Long other) {
    const UnsignedLong large = magnitude(one);
    const UnsignedLong by = magnitude(other);
    const Limbs limbs{static_cast<std::uint64_t>(large), static_cast<std::uint64_t>(large >> limb_bits)};
    Wide result;
    result.add_product(limbs, 2, static_cast<std::uint64_t>(by), 0);
    result.add_product(limbs, 2, static_cast<std::uint64_t>(by >> limb_bits), 1);
    return (one < 0) != (other < 0) ? -result : result;
  }

  /// The low 448 bits.
  [[nodiscard]] Wide times(Long other) const {
    const bool is_negative = negative() != (other < 0);
    const Limbs limbs = negative() ? (-*this).limbs_ : limbs_;
    std::size_t count = limbs.size();
    while (count > 0 && limbs[count - 1] == 0) --count;
    const UnsignedLong by = magnitude(other);
    Wide result;
    result.add_product(limbs, count, static_cast<std::uint64_t>(by), 0);
    result.add_product(limbs, count, static_cast<std::uint64_t>(by >> limb_bits), 1);
    return is_negative ? -result : result;
  }

  Wide operator-() const {
    Wide result;
    UnsignedLong carry = 1;
    for (std::size_t i = 0; i < limbs_.size(); ++i) {
      carry += ~limbs_[i];
      result.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    return result;
  }

  Wide& operator+=(const Wide& other) {
    UnsignedLong carry = 0;
    for (std::size_t i = 0; i < limbs_.size(); ++i) {
      carry += static_cast<UnsignedLong>(limbs_[i]) + other.limbs_[i];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    return *this;
  }

  Wide& operator-=(const Wide& other) { return *this += -other; }

  [[nodiscard]] bool negative() const { return (limbs_.back() >> (limb_bits - 1)) != 0; }

  [[nodiscard]] int sign() const {
    if (negative()) return -1;
    return std::ranges::any_of(limbs_, [](std::uint64_t limb) { return limb != 0; }) ? 1 : 0;
  }

  /// Off by less than two units of the last place.
  [[nodiscard]] double rounded() const {
    if (negative()) return -(-*this).rounded();
    double sum = 0;
    for (std::size_t i = limbs_.size(); i-- > 0;) sum = sum * 0x1p64 + static_cast<double>(limbs_[i]);
    return sum;
  }

 private:
  using Limbs = std::array<std::uint64_t, 7>;
  static constexpr unsigned limb_bits = 64;

  static UnsignedLong magnitude(Long number) {
    return number < 0 ? -static_cast<UnsignedLong>(number) : static_cast<UnsignedLong>(number);
  }

  /// Adds the product of some low limbs, moved up. What is past the last limb is lost.
  void add_product(const Limbs& one, std::size_t count, std::uint64_t other, std::size_t up) {
    if (other == 0) return;
    UnsignedLong carry = 0;
    std::size_t i = up;
    for (; i < std::min(count + up, limbs_.size()); ++i) {
      carry += static_cast<UnsignedLong>(one[i - up]) * other + limbs_[i];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    for (; carry != 0 && i < limbs_.size(); ++i) {
      carry += limbs_[i];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
  }

  Limbs limbs_{};  ///< the lowest first
};

}  // namespace csgsim::software
