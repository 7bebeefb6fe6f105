// Included once for each instruction set, by Highway's rule: no plain include guard.
#if defined(CSGSIM_BYTES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_BYTES_INL_H
#undef CSGSIM_BYTES_INL_H
#else
#define CSGSIM_BYTES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "sim/functional/mask_bits-inl.h"
#include "sim/functional/tile_bits.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

// Numbers and words of their bits by bytes: a vector has a byte of each of several numbers, and a mask of it a bit of
// each.

constexpr unsigned bits_a_byte = 8;

/// A byte of each number of a block.
class Bytes {
 public:
  /// That byte of the numbers, the lowest being 0. The tag is of vectors of unsigned numbers.
  template <class Tag>
  HWY_INLINE void take(Tag tag, const hwy::HWY_NAMESPACE::TFromD<Tag>* numbers, unsigned byte) {
    namespace hn = hwy::HWY_NAMESPACE;
    constexpr hn::Rebind<std::uint8_t, Tag> byte_tag;
    const int shift = static_cast<int>(byte * bits_a_byte);
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag))
      hn::StoreU(hn::TruncateTo(byte_tag, hn::ShiftRightSame(hn::LoadU(tag, numbers + from), shift)), byte_tag,
                 bytes_ + from);
  }

  /// A word a bit, the lowest first; at most 8.
  HWY_INLINE void put(std::span<const std::uint64_t> words) {
    namespace hn = hwy::HWY_NAMESPACE;
    constexpr ByteTag tag;
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
      auto all = hn::Zero(tag);
      for (std::size_t i = 0; i < words.size(); ++i)
        all = hn::Or(all, hn::IfThenElseZero(mask_of_bits(tag, words[i] >> from),
                                             hn::Set(tag, static_cast<std::uint8_t>(1U << i))));
      hn::Store(all, tag, bytes_ + from);
    }
  }

  /// That bit of the bytes.
  [[nodiscard]] HWY_INLINE std::uint64_t word(unsigned bit) const {
    namespace hn = hwy::HWY_NAMESPACE;
    constexpr ByteTag tag;
    const auto one = hn::Set(tag, static_cast<std::uint8_t>(1U << bit));
    std::uint64_t word = 0;
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag))
      word |= bits_of_mask(tag, hn::TestBit(hn::Load(tag, bytes_ + from), one)) << from;
    return word;
  }

  /// A vector of the bytes as numbers.
  template <class Tag>
  [[nodiscard]] HWY_INLINE auto at(Tag tag, std::size_t from) const {
    namespace hn = hwy::HWY_NAMESPACE;
    return hn::PromoteTo(tag, hn::LoadU(hn::Rebind<std::uint8_t, Tag>(), bytes_ + from));
  }

 private:
  using ByteTag = hwy::HWY_NAMESPACE::CappedTag<std::uint8_t, block_pixels>;

  HWY_ALIGN std::uint8_t bytes_[block_pixels];
};

/// Of a block's numbers the bits from `first` on, a word each, 1 at least.
template <class Tag>
HWY_INLINE void words_of(Tag tag, const hwy::HWY_NAMESPACE::TFromD<Tag>* numbers, unsigned first,
                         std::span<std::uint64_t> words) {
  Bytes bytes[sizeof(*numbers)];
  const auto count = static_cast<unsigned>(words.size());
  const unsigned last_byte = (first + count - 1) / bits_a_byte;
  for (unsigned byte = first / bits_a_byte; byte <= last_byte; ++byte) bytes[byte].take(tag, numbers, byte);
  for (unsigned i = 0; i < count; ++i) words[i] = bytes[(first + i) / bits_a_byte].word((first + i) % bits_a_byte);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
