// Included once per instruction set, as Highway requires, hence no plain include guard.
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

// Transposition of numbers to words of their bits, by bytes: a vector holds one byte of each of several numbers, and a
// mask of it one bit of each.

constexpr unsigned bits_per_byte = 8;

/// One byte of each number of a block.
class Bytes {
 public:
  /// Loads byte `byte` of each number, where 0 is the lowest. The tag selects vectors of unsigned numbers.
  template <class Tag>
  HWY_INLINE void load(Tag tag, const hwy::HWY_NAMESPACE::TFromD<Tag>* numbers, unsigned byte) {
    namespace hn = hwy::HWY_NAMESPACE;
    constexpr hn::Rebind<std::uint8_t, Tag> byte_tag;
    const int shift = static_cast<int>(byte * bits_per_byte);
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag))
      hn::StoreU(hn::TruncateTo(byte_tag, hn::ShiftRightSame(hn::LoadU(tag, numbers + from), shift)), byte_tag,
                 bytes_ + from);
  }

  /// Sets the bits of the bytes from at most 8 words, lowest bit first.
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

  /// The word of that bit of all bytes.
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

/// Writes the bits from `first` on of a block's numbers, one word for each bit; at least one.
template <class Tag>
HWY_INLINE void extract_words(Tag tag, const hwy::HWY_NAMESPACE::TFromD<Tag>* numbers, unsigned first,
                              std::span<std::uint64_t> words) {
  Bytes bytes[sizeof(*numbers)];
  const auto count = static_cast<unsigned>(words.size());
  const unsigned last_byte = (first + count - 1) / bits_per_byte;
  for (unsigned byte = first / bits_per_byte; byte <= last_byte; ++byte) bytes[byte].load(tag, numbers, byte);
  for (unsigned i = 0; i < count; ++i) words[i] = bytes[(first + i) / bits_per_byte].word((first + i) % bits_per_byte);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
