#include "sim/functional/lane_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/functional/lane_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <algorithm>

#include "sim/functional/block_lanes-inl.h"
#include "sim/functional/bytes-inl.h"
#include "sim/functional/mask_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void count_work(const EnabledPixels& pixels, std::uint64_t blocks) {
  const auto number = static_cast<std::uint64_t>(std::popcount(blocks));
  pixels.work.words += number;
  pixels.work.lanes += number * block_pixels;
}

void set_block(const EnabledPixels& pixels, Lanes& lanes, unsigned block, std::uint32_t value) {
  if (lanes.is_constant(block)) {
    if (lanes.least[block] == value) return;
    fill(lanes, block);
  }
  write_block(lanes.block(block), pixels.enable.word(block, pixels.shape),
              [&](std::size_t /*from*/, Numbers /*old*/) { return hn::Set(NumberTag(), value); });
  widen(lanes, block, value, value);
}

void set_all(const EnabledPixels& pixels, Lanes& lanes, std::uint32_t value) {
  each_bit(pixels.enable.full(), [&](unsigned block) { lanes.set_constant(block, value); });
  count_work(pixels, pixels.enable.mixed());
  each_bit(pixels.enable.mixed(), [&](unsigned block) { set_block(pixels, lanes, block, value); });
}

void copy_block(const EnabledPixels& pixels, Lanes& target, const Lanes& source, unsigned block) {
  if (source.is_constant(block)) return set_block(pixels, target, block, source.least[block]);
  if (target.is_constant(block)) fill(target, block);
  const std::uint32_t* const from_block = source.block(block);
  write_block(target.block(block), pixels.enable.word(block, pixels.shape),
              [&](std::size_t from, Numbers /*old*/) { return hn::LoadU(NumberTag(), from_block + from); });
  widen(target, block, source.least[block], source.greatest[block]);
}

void copy_all(const EnabledPixels& pixels, Lanes& target, const Lanes& source) {
  std::uint64_t moved = pixels.enable.mixed();
  each_bit(pixels.enable.full(), [&](unsigned block) {
    target.least[block] = source.least[block];
    target.greatest[block] = source.greatest[block];
    if (source.is_constant(block)) return;
    moved |= std::uint64_t{1} << block;
    std::copy_n(source.block(block), block_pixels, target.block(block));
  });
  count_work(pixels, moved);
  each_bit(pixels.enable.mixed(), [&](unsigned block) { copy_block(pixels, target, source, block); });
}

void add_all(const EnabledPixels& pixels, Lanes& target, const Lanes& source, std::uint32_t low_bits) {
  count_work(pixels, pixels.enable.any());
  each_bit(pixels.enable.any(), [&](unsigned block) {
    if (target.is_constant(block)) fill(target, block);
    const BlockNumbers addend(source, block);
    write_block(target.block(block), pixels.enable.word(block, pixels.shape), [&](std::size_t from, Numbers old) {
      return hn::And(hn::Add(old, addend.at(from)), hn::Set(NumberTag(), low_bits));
    });
    bound(target, block);
  });
}

/// Blocks in which, by their bounds, all values of one are less than all of the other.
std::uint64_t all_less(const Bounds& greatest, const Bounds& least) {
  return each_bound(greatest, least, [](Numbers high, Numbers low) { return hn::Lt(high, low); });
}
std::uint64_t all_less_or_equal(const Bounds& greatest, const Bounds& least) {
  return each_bound(greatest, least, [](Numbers high, Numbers low) { return hn::Not(hn::Gt(high, low)); });
}
std::uint64_t equal_bounds(const Bounds& left, const Bounds& right) {
  return each_bound(left, right, [](Numbers l, Numbers r) { return hn::Eq(l, r); });
}

/// Blocks for which a test has the same result at every pixel.
struct Decided {
  std::uint64_t all = 0;
  std::uint64_t none = 0;
};

Decided decided(Comparison comparison, const Lanes& left, const Lanes& right) {
  switch (comparison) {
    case Comparison::less: return {all_less(left.greatest, right.least), all_less_or_equal(right.greatest, left.least)};
    case Comparison::less_or_equal:
      return {all_less_or_equal(left.greatest, right.least), all_less(right.greatest, left.least)};
    case Comparison::equal: break;
  }
  return {equal_bounds(left.least, left.greatest) & equal_bounds(right.least, right.greatest) &
              equal_bounds(left.least, right.least),
          all_less(left.greatest, right.least) | all_less(right.greatest, left.least)};
}

template <class Holds>
void test_blocks(const EnabledPixels& pixels, std::uint64_t blocks, const Lanes& left, const Lanes& right,
                 const Holds& holds) {
  each_bit(blocks, [&](unsigned block) {
    const BlockNumbers l(left, block);
    const BlockNumbers r(right, block);
    const std::uint64_t word = test_block([&](std::size_t from) { return holds(l.at(from), r.at(from)); });
    pixels.enable.set_word(block, pixels.enable.word(block, pixels.shape) & word, pixels.shape);
  });
}

void compare_blocks(const EnabledPixels& pixels, Comparison comparison, const Lanes& left, const Lanes& right) {
  const Decided by_bounds = pixels.decide == Decide::by_block ? decided(comparison, left, right) : Decided{};
  pixels.enable.clear_blocks(by_bounds.none);
  const std::uint64_t open = pixels.enable.any() & ~by_bounds.all;
  count_work(pixels, open);
  switch (comparison) {
    case Comparison::less:
      return test_blocks(pixels, open, left, right, [](Numbers l, Numbers r) { return hn::Lt(l, r); });
    case Comparison::less_or_equal:
      return test_blocks(pixels, open, left, right, [](Numbers l, Numbers r) { return hn::Not(hn::Gt(l, r)); });
    case Comparison::equal:
      return test_blocks(pixels, open, left, right, [](Numbers l, Numbers r) { return hn::Eq(l, r); });
  }
}

std::uint32_t compare_all(const EnabledPixels& pixels, Comparison comparison, const Lanes& left, const Lanes& right) {
  compare_blocks(pixels, comparison, left, right);
  return count(pixels.enable, pixels.shape);
}

std::uint32_t count_all(const TileBits& bits, const TileShape& shape) { return count(bits, shape); }

void fill_one(Lanes& lanes, unsigned block) { fill(lanes, block); }
void bound_one(Lanes& lanes, unsigned block) { bound(lanes, block); }

/// One bit of each of 64 values.
std::uint64_t gather_bit(const std::uint32_t* values, unsigned bit) {
  const Numbers one = hn::Set(NumberTag(), std::uint32_t{1} << bit);
  return test_block([&](std::size_t from) { return hn::TestBit(hn::LoadU(NumberTag(), values + from), one); });
}

using PlaneWords = std::array<std::uint64_t, isa::max_field_width>;

void gather_all(const Lanes& lanes, const TileShape& shape, std::uint64_t blocks, unsigned first,
                std::span<TileBits* const> planes) {
  const std::uint64_t there = blocks & shape.blocks();
  const std::uint64_t constant = there & equal_bounds(lanes.least, lanes.greatest);
  const auto count = static_cast<unsigned>(planes.size());
  PlaneWords words;
  PlaneWords any{};
  PlaneWords full{};
  for (unsigned i = 0; i < count; ++i) any[i] = full[i] = constant & gather_bit(lanes.least.data(), first + i);
  each_bit(there & ~constant, [&](unsigned block) {
    const std::uint64_t pixels = shape.pixels(block);
    extract_words(NumberTag(), lanes.block(block), first, std::span(words).first(count));
    for (unsigned i = 0; i < count; ++i) {
      const std::uint64_t word = words[i] & pixels;
      planes[i]->write_word(block, word);
      any[i] |= std::uint64_t{word != 0} << block;
      full[i] |= std::uint64_t{word == pixels} << block;
    }
  });
  for (unsigned i = 0; i < count; ++i) planes[i]->set_blocks(there, any[i], full[i]);
}

/// Bit planes; null for missing ones.
using SomePlanes = std::span<const TileBits* const>;

/// Writes the numbers of 64 blocks or pixels; bit i of the numbers is the word bit(i).
template <class Bit>
HWY_INLINE void put_numbers(unsigned width, std::uint32_t* numbers, const Bit& bit) {
  constexpr NumberTag tag;
  Bytes bytes[isa::max_field_width / bits_per_byte];
  std::size_t count = 0;
  for (unsigned low = 0; low < width; low += bits_per_byte) {
    std::array<std::uint64_t, bits_per_byte> words{};
    const unsigned bits = std::min(width - low, bits_per_byte);
    for (unsigned i = 0; i < bits; ++i) words[i] = bit(low + i);
    bytes[count++].put(std::span(words).first(bits));
  }
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
    Numbers all = bytes[0].at(tag, from);
    for (std::size_t i = 1; i < count; ++i)
      all = hn::Or(all, hn::ShiftLeftSame(bytes[i].at(tag, from), static_cast<int>(i * bits_per_byte)));
    hn::StoreU(all, tag, numbers + from);
  }
}

/// Sets the blocks that are constant in every plane.
void set_even_blocks(SomePlanes planes, std::uint64_t blocks, Lanes& lanes) {
  constexpr NumberTag tag;
  HWY_ALIGN std::uint32_t numbers[blocks_per_tile];
  put_numbers(static_cast<unsigned>(planes.size()), numbers,
              [&](unsigned bit) { return planes[bit] == nullptr ? 0 : planes[bit]->full(); });
  for (std::size_t from = 0; from < blocks_per_tile; from += hn::Lanes(tag)) {
    const auto there = mask_of_bits(tag, blocks >> from);
    const Numbers number = hn::Load(tag, numbers + from);
    for (Bounds* const bounds : {&lanes.least, &lanes.greatest})
      hn::StoreU(hn::IfThenElse(there, number, hn::LoadU(tag, bounds->data() + from)), tag, bounds->data() + from);
  }
}

void scatter_all(SomePlanes planes, const TileShape& shape, std::uint64_t blocks, Lanes& lanes) {
  std::uint64_t mixed = 0;
  for (const TileBits* const plane : planes) mixed |= plane == nullptr ? 0 : plane->mixed();
  mixed &= blocks;
  if (const std::uint64_t even = blocks & ~mixed; even != 0) set_even_blocks(planes, even, lanes);
  each_bit(mixed, [&](unsigned block) {
    put_numbers(static_cast<unsigned>(planes.size()), lanes.block(block),
                [&](unsigned bit) { return planes[bit] == nullptr ? 0 : planes[bit]->word(block, shape); });
    bound(lanes, block);
  });
}

void merge_all(const Lanes& source, isa::Field part, std::uint64_t blocks, Lanes& target) {
  constexpr NumberTag tag;
  const int right = part.base - source.field.base;
  const int left = part.base - target.field.base;
  const std::uint32_t ones = ~std::uint32_t{0} >> (isa::max_field_width - part.width);
  const auto number = [&](std::uint32_t value) { return (value >> right & ones) << left; };
  each_bit(blocks, [&](unsigned block) {
    if (source.is_constant(block) && target.is_constant(block))
      return target.set_constant(block, target.least[block] | number(source.least[block]));
    const BlockNumbers from_source(source, block);
    const BlockNumbers before(target, block);
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
      const Numbers moved = hn::And(hn::ShiftRightSame(from_source.at(from), right), hn::Set(tag, ones));
      hn::StoreU(hn::Or(before.at(from), hn::ShiftLeftSame(moved, left)), tag, target.block(block) + from);
    }
    bound(target, block);
  });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::functional {

HWY_EXPORT(count_all);
HWY_EXPORT(set_all);
HWY_EXPORT(copy_all);
HWY_EXPORT(add_all);
HWY_EXPORT(compare_all);
HWY_EXPORT(fill_one);
HWY_EXPORT(bound_one);
HWY_EXPORT(gather_all);
HWY_EXPORT(scatter_all);
HWY_EXPORT(merge_all);

std::uint32_t count_ones(const TileBits& bits, const TileShape& shape) {
  return HWY_DYNAMIC_DISPATCH(count_all)(bits, shape);
}

void set_lanes(const EnabledPixels& pixels, Lanes& lanes, std::uint32_t value) {
  HWY_DYNAMIC_DISPATCH(set_all)(pixels, lanes, value);
}

void copy_lanes(const EnabledPixels& pixels, Lanes& target, const Lanes& source) {
  HWY_DYNAMIC_DISPATCH(copy_all)(pixels, target, source);
}

void add_lanes(const EnabledPixels& pixels, Lanes& target, const Lanes& source, std::uint32_t low_bits) {
  HWY_DYNAMIC_DISPATCH(add_all)(pixels, target, source, low_bits);
}

std::uint32_t compare_lanes(const EnabledPixels& pixels, Comparison comparison, const Lanes& left, const Lanes& right) {
  return HWY_DYNAMIC_DISPATCH(compare_all)(pixels, comparison, left, right);
}

void fill_block(Lanes& lanes, unsigned block) { HWY_DYNAMIC_DISPATCH(fill_one)(lanes, block); }
void find_bounds(Lanes& lanes, unsigned block) { HWY_DYNAMIC_DISPATCH(bound_one)(lanes, block); }

void gather_planes(const Lanes& lanes, const TileShape& shape, std::uint64_t block_mask, unsigned first_bit,
                   std::span<TileBits* const> planes) {
  HWY_DYNAMIC_DISPATCH(gather_all)(lanes, shape, block_mask, first_bit, planes);
}

void scatter_planes(std::span<const TileBits* const> planes, const TileShape& shape, std::uint64_t block_mask,
                    Lanes& lanes) {
  HWY_DYNAMIC_DISPATCH(scatter_all)(planes, shape, block_mask, lanes);
}

void merge_lanes(const Lanes& source, isa::Field part, std::uint64_t block_mask, Lanes& target) {
  HWY_DYNAMIC_DISPATCH(merge_all)(source, part, block_mask, target);
}

}  // namespace csgsim::functional
#endif
