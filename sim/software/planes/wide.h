#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace csgsim::software {

__extension__ using Long = __int128;
__extension__ using UnsignedLong = unsigned __int128;

/// A whole number of 256 bits, two's complement: enough for a determinant of four planes, which takes 218.
class Wide {
 public:
  Wide() = default;

  /// Exact: at most 191 bits.
  static Wide product(Long one, std::int64_t other) {
    const bool is_negative = (one < 0) != (other < 0);
    const UnsignedLong large = one < 0 ? -static_cast<UnsignedLong>(one) : static_cast<UnsignedLong>(one);
    Wide result;
    result.multiply({static_cast<std::uint64_t>(large), static_cast<std::uint64_t>(large >> limb_bits), 0, 0},
                    magnitude(other));
    return is_negative ? -result : result;
  }

  /// The low 256 bits.
  [[nodiscard]] Wide times(std::int64_t other) const {
    const bool is_negative = negative() != (other < 0);
    Wide result;
    result.multiply(negative() ? (-*this).limbs_ : limbs_, magnitude(other));
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
    return (limbs_[0] | limbs_[1] | limbs_[2] | limbs_[3]) != 0 ? 1 : 0;
  }

  /// Off by less than two units of the last place.
  [[nodiscard]] double rounded() const {
    if (negative()) return -(-*this).rounded();
    double sum = 0;
    for (std::size_t i = limbs_.size(); i-- > 0;) sum = sum * 0x1p64 + static_cast<double>(limbs_[i]);
    return sum;
  }

 private:
  using Limbs = std::array<std::uint64_t, 4>;
  static constexpr unsigned limb_bits = 64;

  static std::uint64_t magnitude(std::int64_t number) {
    return number < 0 ? -static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number);
  }

  void multiply(const Limbs& one, std::uint64_t other) {
    UnsignedLong carry = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      carry += static_cast<UnsignedLong>(one[i]) * other;
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
  }

  Limbs limbs_{};  ///< the lowest first
};

}  // namespace csgsim::software
