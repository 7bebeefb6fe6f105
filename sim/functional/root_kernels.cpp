#include "sim/functional/root_kernels.h"

#include "hw/isa/instruction.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/functional/root_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// One word for each of several blocks.
using WordTag = hn::CappedTag<std::uint64_t, 8>;
using Words = hn::Vec<WordTag>;

/// A field's bits at the pixels of several blocks.
class Group {
 public:
  HWY_INLINE Words bit(std::size_t number) const { return hn::Load(WordTag(), words_ + number * count()); }
  HWY_INLINE void set_bit(std::size_t number, Words words) { hn::Store(words, WordTag(), words_ + number * count()); }
  [[nodiscard]] std::uint64_t& word(std::size_t number, std::size_t block) { return words_[number * count() + block]; }

  static std::size_t count() { return hn::Lanes(WordTag()); }

 private:
  HWY_ALIGN std::uint64_t words_[isa::max_wide_field_width * 8];
};

HWY_INLINE void add_bit(Group& field, std::size_t number, Words added, Words& carry) {
  const Words old = field.bit(number);
  const Words half = hn::Xor(old, added);
  field.set_bit(number, hn::Xor(half, carry));
  carry = hn::Or(hn::And(old, added), hn::And(half, carry));
}

/// Non-restoring square root in place: a step processes the remainder with two more bits, k + 3 in all, and replaces
/// their top bit by the next bit of the root.
void root(Group& field, std::size_t w) {
  constexpr WordTag tag;
  const Words ones = hn::Set(tag, ~std::uint64_t{0});
  field.set_bit(2 * w, hn::Zero(tag));
  Words subtracts = ones;  // 1 where the remainder is not negative
  for (std::size_t k = 0; k < w; ++k) {
    const std::size_t low = 2 * (w - 1 - k);
    const std::size_t top = 2 * w - k;
    Words carry = subtracts;  // carry of adding 4q + 3, or the complement of 4q + 1, and 1
    add_bit(field, low, hn::Not(subtracts), carry);
    add_bit(field, low + 1, ones, carry);
    for (std::size_t i = 0; i < k; ++i) add_bit(field, low + 2 + i, hn::Xor(field.bit(top + 1 + i), subtracts), carry);
    add_bit(field, top, subtracts, carry);
    subtracts = hn::Not(field.bit(top));
    field.set_bit(top, subtracts);
  }
}

void root_of_planes(const EnabledPixels& pixels, std::span<TileBits* const> planes) {
  std::uint64_t left = pixels.enable.any();
  pixels.work.words += static_cast<std::uint64_t>(std::popcount(left)) * planes.size();
  Group field;
  while (left != 0) {
    unsigned blocks[8];
    std::size_t count = 0;
    for (; left != 0 && count < Group::count(); left &= left - 1)
      blocks[count++] = static_cast<unsigned>(std::countr_zero(left));
    for (std::size_t bit = 0; bit < planes.size(); ++bit)
      for (std::size_t i = 0; i < Group::count(); ++i)
        field.word(bit, i) = i < count ? planes[bit]->word(blocks[i], pixels.shape) : 0;
    root(field, planes.size() / 2);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t enabled = pixels.enable.word(blocks[i], pixels.shape);
      for (std::size_t bit = 0; bit < planes.size(); ++bit) {
        const std::uint64_t old = planes[bit]->word(blocks[i], pixels.shape);
        planes[bit]->set_word(blocks[i], (old & ~enabled) | (field.word(bit, i) & enabled), pixels.shape);
      }
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::functional {

HWY_EXPORT(root_of_planes);

void execute_root(const EnabledPixels& pixels, std::span<TileBits* const> planes) {
  HWY_DYNAMIC_DISPATCH(root_of_planes)(pixels, planes);
}

}  // namespace csgsim::functional
#endif
