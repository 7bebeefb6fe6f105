// Integers of several limbs.
// Used by whole_planes.h.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace csgsim::software {

__extension__ using Long = __int128;
__extension__ using UnsignedLong = unsigned __int128;

/// An integer of `limb_count` 64-bit limbs in two's complement. Overflow beyond the last limb is discarded.
template <std::size_t limb_count>
class Wide {
 public:
  Wide() = default;

  Wide& operator+=(const Wide& other) {
    UnsignedLong carry = 0;
    for (std::size_t i = 0; i < limb_count; ++i) {
      carry += static_cast<UnsignedLong>(limbs_[i]) + other.limbs_[i];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    return *this;
  }

  Wide& operator-=(const Wide& other) {
    UnsignedLong carry = 1;
    for (std::size_t i = 0; i < limb_count; ++i) {
      carry += static_cast<UnsignedLong>(limbs_[i]) + ~other.limbs_[i];
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    return *this;
  }

  Wide operator-() const {
    Wide result;
    result -= *this;
    return result;
  }

  [[nodiscard]] bool negative() const { return (limbs_.back() >> (limb_bits - 1)) != 0; }

  [[nodiscard]] int sign() const {
    if (negative()) return -1;
    return std::ranges::any_of(limbs_, [](std::uint64_t limb) { return limb != 0; }) ? 1 : 0;
  }

  /// Rounded to double, with an error below two units in the last place.
  [[nodiscard]] double rounded() const {
    if (negative()) return -(-*this).rounded();
    double sum = 0;
    for (std::size_t i = limb_count; i-- > 0;) sum = sum * 0x1p64 + static_cast<double>(limbs_[i]);
    return sum;
  }

 private:
  template <std::size_t any>
  friend class Wide;
  template <std::size_t result, std::size_t one>
  friend Wide<result> product(const Wide<one>& a, Long b);
  friend Wide<4> product(Long a, Long b);

  static constexpr unsigned limb_bits = 64;

  /// Adds limb * by, shifted left by `up` limbs.
  template <std::size_t others>
  void add_product(std::uint64_t limb, const std::array<std::uint64_t, others>& by, std::size_t up) {
    UnsignedLong carry = 0;
    for (std::size_t i = 0; i < others && i + up < limb_count; ++i) {
      carry += static_cast<UnsignedLong>(limb) * by[i] + limbs_[i + up];
      limbs_[i + up] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    if (others + up < limb_count) limbs_[others + up] = static_cast<std::uint64_t>(carry);
  }

  /// Subtracts the limbs, shifted left by `up` limbs, if `condition`.
  template <std::size_t others>
  void subtract_if(bool condition, const std::array<std::uint64_t, others>& by, std::size_t up) {
    const std::uint64_t mask = condition ? ~std::uint64_t{0} : 0;
    UnsignedLong carry = 1;
    for (std::size_t i = up; i < limb_count; ++i) {
      carry += static_cast<UnsignedLong>(limbs_[i]) + ~(i - up < others ? by[i - up] & mask : 0);
      limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
  }

  std::array<std::uint64_t, limb_count> limbs_{};  ///< least significant first
};

inline std::array<std::uint64_t, 2> limbs_of(Long number) {
  const auto bits = static_cast<UnsignedLong>(number);
  return {static_cast<std::uint64_t>(bits), static_cast<std::uint64_t>(bits >> 64U)};
}

/// Multiplies limbs as unsigned numbers; a sign bit then counts too much by twice its weight, which is subtracted.
template <std::size_t result, std::size_t one>
Wide<result> product(const Wide<one>& a, Long b) {
  const std::array<std::uint64_t, 2> limbs = limbs_of(b);
  Wide<result> sum;
  sum.add_product(limbs[0], a.limbs_, 0);
  sum.add_product(limbs[1], a.limbs_, 1);
  sum.subtract_if(b < 0, a.limbs_, limbs.size());
  sum.subtract_if(a.negative(), limbs, one);
  return sum;
}

inline Wide<4> product(Long a, Long b) {
  Wide<2> wide;
  wide.limbs_ = limbs_of(a);
  return product<4>(wide, b);
}

}  // namespace csgsim::software
