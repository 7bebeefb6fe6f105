// Included once per instruction set, as Highway requires, hence no plain include guard.
#if defined(CSGSIM_BLOCK_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_BLOCK_LANES_INL_H
#undef CSGSIM_BLOCK_LANES_INL_H
#else
#define CSGSIM_BLOCK_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "sim/functional/lanes.h"
#include "sim/functional/mask_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

/// Vectors of a block's values.
using NumberTag = hwy::HWY_NAMESPACE::CappedTag<std::uint32_t, block_pixels>;
using Numbers = hwy::HWY_NAMESPACE::Vec<NumberTag>;

/// The values of a block as vectors, whether it is constant or not.
class BlockNumbers {
 public:
  HWY_INLINE BlockNumbers(const Lanes& lanes, unsigned block)
      : values_(lanes.is_constant(block) ? nullptr : lanes.block(block)), constant_(lanes.least[block]) {}
  [[nodiscard]] HWY_INLINE Numbers at(std::size_t from) const {
    namespace hn = hwy::HWY_NAMESPACE;
    return values_ == nullptr ? hn::Set(NumberTag(), constant_) : hn::LoadU(NumberTag(), values_ + from);
  }

 private:
  const std::uint32_t* values_;
  std::uint32_t constant_;
};

/// values := value(index of the vector's first value, old vector) where the bits are 1.
template <class Value>
HWY_INLINE void write_block(std::uint32_t* values, std::uint64_t bits, const Value& value) {
  namespace hn = hwy::HWY_NAMESPACE;
  constexpr NumberTag tag;
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
    const Numbers old = hn::LoadU(tag, values + from);
    hn::StoreU(hn::IfThenElse(mask_of_bits(tag, bits >> from), value(from, old), old), tag, values + from);
  }
}

/// A bit for each value of a block; holds(index of the vector's first value) returns the mask of a vector.
template <class Holds>
HWY_INLINE std::uint64_t test_block(const Holds& holds) {
  namespace hn = hwy::HWY_NAMESPACE;
  constexpr NumberTag tag;
  std::uint64_t word = 0;
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag))
    word |= bits_of_mask(tag, holds(from)) << from;
  return word;
}

/// Number of ones at the pixels of a tile, with the instruction set's own bit count.
HWY_INLINE std::uint32_t count(const TileBits& bits, const TileShape& shape) {
  auto ones = static_cast<std::uint32_t>(std::popcount(bits.full() & shape.whole())) * block_pixels;
  const auto add = [&](unsigned block) { ones += static_cast<std::uint32_t>(std::popcount(bits.word(block, shape))); };
  each_bit(bits.any() & ~(bits.full() & shape.whole()), add);
  return ones;
}

using Bounds = std::array<std::uint32_t, blocks_per_tile>;

/// A bit for each block: holds(left, right) of its bounds.
template <class Holds>
HWY_INLINE std::uint64_t each_bound(const Bounds& left, const Bounds& right, const Holds& holds) {
  namespace hn = hwy::HWY_NAMESPACE;
  return test_block([&](std::size_t from) {
    return holds(hn::LoadU(NumberTag(), left.data() + from), hn::LoadU(NumberTag(), right.data() + from));
  });
}

HWY_INLINE void fill(Lanes& lanes, unsigned block) {
  std::fill_n(lanes.block(block), block_pixels, lanes.least[block]);
}

HWY_INLINE void widen(Lanes& lanes, unsigned block, std::uint32_t least, std::uint32_t greatest) {
  lanes.least[block] = std::min(lanes.least[block], least);
  lanes.greatest[block] = std::max(lanes.greatest[block], greatest);
}

HWY_INLINE void bound(Lanes& lanes, unsigned block) {
  namespace hn = hwy::HWY_NAMESPACE;
  constexpr NumberTag tag;
  Numbers least = hn::LoadU(tag, lanes.block(block));
  Numbers greatest = least;
  for (std::size_t from = hn::Lanes(tag); from < block_pixels; from += hn::Lanes(tag)) {
    const Numbers values = hn::LoadU(tag, lanes.block(block) + from);
    least = hn::Min(least, values);
    greatest = hn::Max(greatest, values);
  }
  lanes.least[block] = hn::GetLane(hn::MinOfLanes(tag, least));
  lanes.greatest[block] = hn::GetLane(hn::MaxOfLanes(tag, greatest));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
