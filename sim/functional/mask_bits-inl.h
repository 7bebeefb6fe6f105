// Included once per instruction set, as Highway requires, hence no plain include guard.
#if defined(CSGSIM_MASK_BITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_MASK_BITS_INL_H
#undef CSGSIM_MASK_BITS_INL_H
#else
#define CSGSIM_MASK_BITS_INL_H
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

/// The mask whose lane i is bit i of the word; bits beyond the lanes are ignored.
template <class Tag>
HWY_INLINE hwy::HWY_NAMESPACE::Mask<Tag> mask_of_bits(Tag tag, std::uint64_t bits) {
  std::uint8_t bytes[sizeof bits];
  std::memcpy(bytes, &bits, sizeof bits);
  return hwy::HWY_NAMESPACE::LoadMaskBits(tag, bytes);
}

/// The word whose bit i is lane i of the mask; bits beyond the lanes are 0.
template <class Tag>
HWY_INLINE std::uint64_t bits_of_mask(Tag tag, hwy::HWY_NAMESPACE::Mask<Tag> mask) {
  std::uint64_t bits = 0;
  std::uint8_t bytes[sizeof bits] = {};
  hwy::HWY_NAMESPACE::StoreMaskBits(tag, mask, bytes);
  std::memcpy(&bits, bytes, sizeof bits);
  return bits;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
