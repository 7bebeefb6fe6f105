#include "sim/functional/word_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/functional/word_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <array>
#include <bit>

#include "hw/isa/instruction.h"
#include "sim/functional/mask_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::sim {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<std::uint32_t>;
using Vector = hn::Vec<Tag>;

Tally tally_words(const WordBlock& block) {
  std::array<std::uint64_t, isa::max_array_side / word_bits> any_in_column;
  std::fill_n(any_in_column.begin(), block.columns, 0);
  Tally result;
  std::size_t first_row = block.rows;
  std::size_t end_row = 0;
  for (std::size_t row = 0; row < block.rows; ++row) {
    const std::uint64_t* const words = block.words + row * block.stride;
    std::uint64_t any = 0;
    for (std::size_t column = 0; column < block.columns; ++column) {
      const std::uint64_t word = words[column];
      any |= word;
      any_in_column[column] |= word;
      result.ones += static_cast<std::uint64_t>(std::popcount(word));
    }
    if (any == 0) continue;
    first_row = std::min(first_row, row);
    end_row = row + 1;
  }
  if (result.ones == 0) return result;

  std::size_t first_column = 0;
  while (any_in_column[first_column] == 0) ++first_column;
  std::size_t last_column = block.columns - 1;
  while (any_in_column[last_column] == 0) --last_column;
  const auto x0 = first_column * word_bits + static_cast<std::size_t>(std::countr_zero(any_in_column[first_column]));
  const auto x1 =
      (last_column + 1) * word_bits - static_cast<std::size_t>(std::countl_zero(any_in_column[last_column]));
  result.bounds = {static_cast<std::uint32_t>(x0), static_cast<std::uint32_t>(first_row),
                   static_cast<std::uint32_t>(x1), static_cast<std::uint32_t>(end_row)};
  return result;
}

/// Calls group(enabled, lane) for each vector of lanes that an enabled pixel lies in: the vector's enable bits
/// and its first lane counted from the block's first pixel. A group's result has a bit a lane; finish(word,
/// result) gets those of a word.
template <class Group, class Finish>
HWY_INLINE void each_group(const WordBlock& block, const Group& group, const Finish& finish) {
  constexpr Tag tag;
  const std::size_t count = hn::Lanes(tag);
  for (std::size_t row = 0; row < block.rows; ++row)
    for (std::size_t column = 0; column < block.columns; ++column) {
      const std::size_t index = row * block.stride + column;
      const std::uint64_t enabled = block.words[index];
      if (enabled == 0) continue;
      const std::size_t end = word_bits - static_cast<std::size_t>(std::countl_zero(enabled));
      const std::size_t first = static_cast<std::size_t>(std::countr_zero(enabled)) & ~(count - 1);
      std::uint64_t result = 0;
      for (std::size_t from = first; from < end; from += count)
        result |= group(enabled >> from, index * word_bits + from) << from;
      finish(block.words[index], result);
    }
}

/// Of loops that write lanes and leave the words as they are.
struct KeepWord {
  HWY_INLINE void operator()(std::uint64_t&, std::uint64_t) const {}
};

struct Set {
  std::uint32_t* lanes;
  std::uint32_t value;
  HWY_INLINE std::uint64_t operator()(std::uint64_t enabled, std::size_t lane) const {
    constexpr Tag tag;
    const auto mask = mask_of_bits(tag, enabled);
    const Vector old = hn::LoadU(tag, lanes + lane);
    hn::StoreU(hn::IfThenElse(mask, hn::Set(tag, value), old), tag, lanes + lane);
    return 0;
  }
};

struct Copy {
  std::uint32_t* target;
  const std::uint32_t* source;
  HWY_INLINE std::uint64_t operator()(std::uint64_t enabled, std::size_t lane) const {
    constexpr Tag tag;
    const auto mask = mask_of_bits(tag, enabled);
    const Vector old = hn::LoadU(tag, target + lane);
    hn::StoreU(hn::IfThenElse(mask, hn::LoadU(tag, source + lane), old), tag, target + lane);
    return 0;
  }
};

struct Add {
  std::uint32_t* target;
  const std::uint32_t* source;
  std::uint32_t low_bits;
  HWY_INLINE std::uint64_t operator()(std::uint64_t enabled, std::size_t lane) const {
    constexpr Tag tag;
    const auto mask = mask_of_bits(tag, enabled);
    const Vector old = hn::LoadU(tag, target + lane);
    const Vector sum = hn::And(hn::Add(old, hn::LoadU(tag, source + lane)), hn::Set(tag, low_bits));
    hn::StoreU(hn::IfThenElse(mask, sum, old), tag, target + lane);
    return 0;
  }
};

struct Greater {
  const std::uint32_t* left;
  const std::uint32_t* right;
  HWY_INLINE std::uint64_t operator()(std::uint64_t, std::size_t lane) const {
    constexpr Tag tag;
    return bits_of_mask(tag, hn::Gt(hn::LoadU(tag, left + lane), hn::LoadU(tag, right + lane)));
  }
};

struct Equal {
  const std::uint32_t* left;
  const std::uint32_t* right;
  HWY_INLINE std::uint64_t operator()(std::uint64_t, std::size_t lane) const {
    constexpr Tag tag;
    return bits_of_mask(tag, hn::Eq(hn::LoadU(tag, left + lane), hn::LoadU(tag, right + lane)));
  }
};

struct AndWord {
  HWY_INLINE void operator()(std::uint64_t& word, std::uint64_t result) const { word &= result; }
};

struct AndNotWord {
  HWY_INLINE void operator()(std::uint64_t& word, std::uint64_t result) const { word &= ~result; }
};

void set_all(const WordBlock& enable, std::uint32_t* lanes, std::uint32_t value) {
  each_group(enable, Set{lanes, value}, KeepWord());
}

void copy_all(const WordBlock& enable, std::uint32_t* target, const std::uint32_t* source) {
  each_group(enable, Copy{target, source}, KeepWord());
}

void add_all(const WordBlock& enable, std::uint32_t* target, const std::uint32_t* source, std::uint32_t low_bits) {
  each_group(enable, Add{target, source, low_bits}, KeepWord());
}

void compare_all(const WordBlock& enable, Comparison comparison, const std::uint32_t* left,
                 const std::uint32_t* right) {
  switch (comparison) {
    case Comparison::less: return each_group(enable, Greater{right, left}, AndWord());
    case Comparison::less_or_equal: return each_group(enable, Greater{left, right}, AndNotWord());
    case Comparison::equal: return each_group(enable, Equal{left, right}, AndWord());
  }
}

void gather(const WordBlock& bits, const std::uint32_t* lanes, unsigned bit) {
  constexpr Tag tag;
  const Vector one = hn::Set(tag, std::uint32_t{1} << bit);
  for (std::size_t row = 0; row < bits.rows; ++row)
    for (std::size_t column = 0; column < bits.columns; ++column) {
      const std::size_t index = row * bits.stride + column;
      std::uint64_t word = 0;
      for (std::size_t from = 0; from < word_bits; from += hn::Lanes(tag))
        word |= bits_of_mask(tag, hn::TestBit(hn::LoadU(tag, lanes + index * word_bits + from), one)) << from;
      bits.words[index] = word;
    }
}

struct Scatter {
  std::uint32_t* lanes;
  std::uint32_t one;
  HWY_INLINE std::uint64_t operator()(std::uint64_t enabled, std::size_t lane) const {
    constexpr Tag tag;
    const Vector bit = hn::IfThenElseZero(mask_of_bits(tag, enabled), hn::Set(tag, one));
    hn::StoreU(hn::Or(hn::LoadU(tag, lanes + lane), bit), tag, lanes + lane);
    return 0;
  }
};

void scatter(const WordBlock& bits, std::uint32_t* lanes, unsigned bit) {
  each_group(bits, Scatter{lanes, std::uint32_t{1} << bit}, KeepWord());
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::sim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::sim {

HWY_EXPORT(tally_words);
HWY_EXPORT(set_all);
HWY_EXPORT(copy_all);
HWY_EXPORT(add_all);
HWY_EXPORT(compare_all);
HWY_EXPORT(gather);
HWY_EXPORT(scatter);

Tally tally(const WordBlock& block) { return HWY_DYNAMIC_DISPATCH(tally_words)(block); }

void set_lanes(const WordBlock& enable, std::uint32_t* lanes, std::uint32_t value) {
  HWY_DYNAMIC_DISPATCH(set_all)(enable, lanes, value);
}

void copy_lanes(const WordBlock& enable, std::uint32_t* target, const std::uint32_t* source) {
  HWY_DYNAMIC_DISPATCH(copy_all)(enable, target, source);
}

void add_lanes(const WordBlock& enable, std::uint32_t* target, const std::uint32_t* source, std::uint32_t low_bits) {
  HWY_DYNAMIC_DISPATCH(add_all)(enable, target, source, low_bits);
}

void compare_lanes(const WordBlock& enable, Comparison comparison, const std::uint32_t* left,
                   const std::uint32_t* right) {
  HWY_DYNAMIC_DISPATCH(compare_all)(enable, comparison, left, right);
}

void gather_bit(const WordBlock& bits, const std::uint32_t* lanes, unsigned bit) {
  HWY_DYNAMIC_DISPATCH(gather)(bits, lanes, bit);
}

void scatter_bit(const WordBlock& bits, std::uint32_t* lanes, unsigned bit) {
  HWY_DYNAMIC_DISPATCH(scatter)(bits, lanes, bit);
}

}  // namespace csgsim::sim
#endif
