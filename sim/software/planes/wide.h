#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace csgsim::software {

__extension__ using Long = __int128;
__extension__ using UnsignedLong = unsigned __int128;

/// A whole number of 320 bits, two's complement: enough for a determinant of four planes, which takes 312.
class Wide {
 public:
  Wide() = default;

  /// Exact.
  static Wide product(Long one, Long other) {
    const UnsignedLong large = magnitude(one);
    Wide result;
    result.limbs_[0] = static_cast<std::uint64_t>(large);
    result.limbs_[1] = static_cast<std::uint64_t>(large >> limb_bits);
    if (one < 0) result = -result;
    return result.times(other);
  }

  /// The low 320 bits.
  [[nodiscard]] Wide times(std::int64_t other) const {
    const bool is_negative = negative() != (other < 0);
    const Limbs limbs = negative() ? (-*this).limbs_ : limbs_;
    Wide result;
    result.add_product(limbs, static_cast<std::uint64_t>(magnitude(other)), 0);
    return is_negative ? -result : result;
  }

  [[nodiscard]] Wide times(Long other) const {
    const bool is_negative = negative() != (other < 0);
    const Limbs limbs = negative() ? (-*this).limbs_ : limbs_;
    const UnsignedLong large = magnitude(other);
    Wide result;
    result.add_product(limbs, static_cast<std::uint64_t>(large), 0);
    result.add_product(limbs, static_cast<std::uint64_t>(large >> limb_bits), 1);
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
  using Limbs = std::array<std::uint64_t, 5>;
  static constexpr unsigned limb_bits = 64;

  static UnsignedLong magnitude(Long number) {
    return number < 0 ? -static_cast<UnsignedLong>(number) : static_cast<UnsignedLong>(number);
  }

  /// Adds the product, moved up by some limbs. What is past the last limb is lost.
  void add_product(const Limbs& one, std::uint64_t other, std::size_t up) {
    UnsignedLong carry = 0;
    for (std::size_t i = 0; i + up < limbs_.size(); ++i) {
      carry += static_cast<UnsignedLong>(one[i]) * other + limbs_[i + up];
      limbs_[i + up] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
  }

  Limbs limbs_{};  ///< the lowest first
};

}  // namespace csgsim::software
