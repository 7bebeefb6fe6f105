// Included once for each instruction set, by Highway's rule: no plain include guard.
#if defined(CSGSIM_TRANSPOSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_TRANSPOSE_INL_H
#undef CSGSIM_TRANSPOSE_INL_H
#else
#define CSGSIM_TRANSPOSE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

/// 64 words of 64 bits: bit i of word j becomes bit j of word i. Squares of half the side change places, then those
/// within each.
HWY_INLINE void transpose(std::uint64_t* words) {
  namespace hn = hwy::HWY_NAMESPACE;
  std::uint64_t low = 0x00000000ffffffffU;
  for (std::size_t half = 32; half != 0; half /= 2, low ^= low << half) {
    const auto swap = [&](auto tag, std::size_t word) {
      const auto upper = hn::LoadU(tag, words + word);
      const auto lower = hn::LoadU(tag, words + word + half);
      const auto moved = hn::And(hn::Xor(hn::ShiftRightSame(upper, static_cast<int>(half)), lower), hn::Set(tag, low));
      hn::StoreU(hn::Xor(upper, hn::ShiftLeftSame(moved, static_cast<int>(half))), tag, words + word);
      hn::StoreU(hn::Xor(lower, moved), tag, words + word + half);
    };
    constexpr hn::CappedTag<std::uint64_t, 8> wide;
    constexpr hn::CappedTag<std::uint64_t, 1> single;
    for (std::size_t first = 0; first < 64; first += 2 * half) {
      std::size_t word = first;
      for (; word + hn::Lanes(wide) <= first + half; word += hn::Lanes(wide)) swap(wide, word);
      for (; word < first + half; ++word) swap(single, word);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
