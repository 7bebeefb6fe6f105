// Included once per instruction set, as Highway requires, hence no plain include guard.
#if defined(CSGSIM_LINEAR_DECIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef CSGSIM_LINEAR_DECIDE_INL_H
#undef CSGSIM_LINEAR_DECIDE_INL_H
#else
#define CSGSIM_LINEAR_DECIDE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <optional>

#include "sim/functional/linear_test-inl.h"
#include "sim/functional/mask_bits-inl.h"
#include "sim/functional/plane_sum.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Decisions for whole blocks: F's minimum and maximum against those of z.

using SumTag = hn::CappedTag<std::int64_t, blocks_per_side>;
using Sums = hn::Vec<SumTag>;
using SumMask = hn::Mask<SumTag>;

/// Blocks whose pixels all have the same result. Blocks at which the sum may wrap are only in `may_wrap`.
struct Decided {
  std::uint64_t all = 0;   ///< the test holds
  std::uint64_t none = 0;  ///< the test does not hold
  std::uint64_t fits = 0;  ///< F fits the field; only for kinds that write
  std::uint64_t may_wrap = 0;
};

/// Bounds of F and of z for several blocks.
struct Range {
  Sums f_least;
  Sums f_greatest;
  Sums z_least;
  Sums z_greatest;
};

template <LinearKind kind>
HWY_INLINE SumMask holds_throughout(const Range& r) {
  using enum LinearKind;
  if constexpr (kind == not_negative || kind == greater_or_equal || kind == greater || kind == keep_max)
    return test<kind>(r.f_least, r.z_greatest);
  else if constexpr (kind == equal)
    return hn::And(hn::And(hn::Eq(r.f_least, r.f_greatest), hn::Eq(r.z_least, r.z_greatest)),
                   hn::Eq(r.f_least, r.z_least));
  else
    return test<kind>(r.f_greatest, r.z_least);
}

template <LinearKind kind>
HWY_INLINE SumMask holds_nowhere(const Range& r) {
  using enum LinearKind;
  if constexpr (kind == not_negative || kind == greater_or_equal || kind == greater || kind == keep_max)
    return hn::Not(test<kind>(r.f_greatest, r.z_least));
  else if constexpr (kind == equal)
    return hn::Or(hn::Gt(r.f_least, r.z_greatest), hn::Lt(r.f_greatest, r.z_least));
  else
    return hn::Not(test<kind>(r.f_least, r.z_greatest));
}

HWY_INLINE Sums bounds_at(const Bounds& bounds, std::size_t block) {
  constexpr hn::Rebind<std::uint32_t, SumTag> narrow;
  constexpr hn::RebindToUnsigned<SumTag> wide;
  return hn::BitCast(SumTag(), hn::PromoteTo(wide, hn::LoadU(narrow, bounds.data() + block)));
}

template <LinearKind kind>
Decided decide_exactly(std::uint64_t enabled, const PlaneSum& sum, const LinearTask& task) {
  constexpr SumTag tag;
  const int shift = task.linear.shift;
  HWY_ALIGN std::int64_t ramp[blocks_per_side];
  for (std::size_t i = 0; i < blocks_per_side; ++i) ramp[i] = sum.column_step() * static_cast<std::int64_t>(i);
  const Sums spread = hn::Set(tag, sum.spread());
  const Sums beyond = hn::Set(tag, writes(kind) ? std::int64_t{1} << task.lanes->field.width : 0);
  const Sums limit = hn::Set(tag, std::int64_t{1} << (task.linear.width - 1));

  Decided decided;
  for (unsigned row = 0; row < blocks_per_side; ++row) {
    if ((enabled >> (row * blocks_per_side) & 0xffU) == 0) continue;
    const Sums first = hn::Set(tag, sum.min_sum(row * blocks_per_side));
    for (std::size_t from = 0; from < blocks_per_side; from += hn::Lanes(tag)) {
      const std::size_t block = row * blocks_per_side + from;
      const Sums low = hn::Add(first, hn::LoadU(tag, ramp + from));
      const Sums high = hn::Add(low, spread);
      Range range{low, high, hn::Zero(tag), hn::Zero(tag)};
      if constexpr (!is_sign(kind)) {
        range = {hn::ShiftRightSame(low, shift), hn::ShiftRightSame(high, shift), bounds_at(task.lanes->least, block),
                 bounds_at(task.lanes->greatest, block)};
      }
      std::uint64_t all = bits_of_mask(tag, holds_throughout<kind>(range));
      std::uint64_t none = bits_of_mask(tag, holds_nowhere<kind>(range));
      std::uint64_t fits = 0;
      if constexpr (writes(kind))
        fits =
            bits_of_mask(tag, hn::And(hn::Not(hn::Lt(range.f_least, hn::Zero(tag))), hn::Lt(range.f_greatest, beyond)));
      if (sum.may_wrap()) {
        const std::uint64_t held =
            bits_of_mask(tag, hn::And(hn::Not(hn::Lt(low, hn::Neg(limit))), hn::Lt(high, limit)));
        all &= held;
        none &= held;
        fits &= held;
        const std::uint64_t whole = (std::uint64_t{1} << hn::Lanes(tag)) - 1;
        decided.may_wrap |= (~held & whole) << block;
      }
      decided.all |= all << block;
      decided.none |= none << block;
      decided.fits |= fits << block;
    }
  }
  return decided;
}

// Decisions in 32 bits: bounds of the sum are rounded outwards, so that some blocks that decide_exactly decides stay
// undecided.

using CoarseTag = hn::CappedTag<std::int32_t, 16>;
using Coarse = hn::Vec<CoarseTag>;

/// A sum divided by 2^dropped, with z and 1 scaled to match.
struct Scale {
  int dropped = 0;          ///< dropped bits of the sum
  int kept = 0;             ///< remaining fraction bits of the sum
  std::int32_t excess = 0;  ///< maximum accumulated rounding
};

constexpr int coarse_bits = 30;

/// The scale on which the numbers of the tile fit coarse_bits bits; empty if there is none.
template <LinearKind kind>
std::optional<Scale> find_scale(const PlaneSum& sum, const LinearTask& task) {
  constexpr int roundings = 2 * (blocks_per_side - 1) + 2;
  if (sum.may_wrap()) return std::nullopt;
  Scale scale;
  scale.dropped = std::max(0, sum.bits() - coarse_bits);
  if constexpr (!is_sign(kind)) {
    const int shift = task.linear.shift;
    scale.dropped = std::max(scale.dropped, shift + task.lanes->field.width - coarse_bits);
    if (scale.dropped > shift) return std::nullopt;
    if (sum.is_flat()) scale.dropped = shift;
    scale.kept = shift - scale.dropped;
  }
  scale.excess = scale.dropped > 0 && !sum.is_flat() ? roundings : 0;
  return scale;
}

/// Bounds of several blocks' sums, and of z, on that scale.
struct CoarseRange {
  Coarse low;
  Coarse high;
  Coarse z_least;
  Coarse z_greatest;
  Coarse one;
};

HWY_INLINE auto at_least(Coarse left, Coarse right) { return hn::Not(hn::Lt(left, right)); }

template <LinearKind kind>
HWY_INLINE auto holds_throughout(const CoarseRange& r, bool is_flat) {
  using enum LinearKind;
  if constexpr (kind == not_negative || kind == greater_or_equal)
    return at_least(r.low, r.z_greatest);
  else if constexpr (kind == greater || kind == keep_max)
    return at_least(r.low, hn::Add(r.z_greatest, r.one));
  else if constexpr (kind == negative || kind == less || kind == keep_min)
    return hn::Lt(r.high, r.z_least);
  else if constexpr (kind == less_or_equal)
    return hn::Lt(r.high, hn::Add(r.z_least, r.one));
  else if constexpr (kind == equal)
    return is_flat ? hn::And(hn::Eq(r.z_least, r.z_greatest), hn::Eq(r.low, r.z_least)) : hn::Lt(r.low, r.low);
  else
    return hn::Eq(r.low, r.low);
}

template <LinearKind kind>
HWY_INLINE auto holds_nowhere(const CoarseRange& r) {
  using enum LinearKind;
  if constexpr (kind == not_negative || kind == greater_or_equal)
    return hn::Lt(r.high, r.z_least);
  else if constexpr (kind == greater || kind == keep_max)
    return hn::Lt(r.high, hn::Add(r.z_least, r.one));
  else if constexpr (kind == negative || kind == less || kind == keep_min)
    return at_least(r.low, r.z_greatest);
  else if constexpr (kind == less_or_equal)
    return at_least(r.low, hn::Add(r.z_greatest, r.one));
  else if constexpr (kind == equal)
    return hn::Or(at_least(r.low, hn::Add(r.z_greatest, r.one)), hn::Lt(r.high, r.z_least));
  else
    return hn::Lt(r.low, r.low);
}

HWY_INLINE Coarse scale_bounds(const Bounds& bounds, std::size_t block, int kept) {
  const Coarse z = hn::BitCast(CoarseTag(), hn::LoadU(hn::RebindToUnsigned<CoarseTag>(), bounds.data() + block));
  return hn::ShiftLeftSame(z, kept);
}

template <LinearKind kind>
Decided decide_coarsely(std::uint64_t enabled, const PlaneSum& sum, const LinearTask& task, const Scale& scale) {
  constexpr CoarseTag tag;
  const std::size_t count = hn::Lanes(tag);
  const auto coarse = [&](std::int64_t value) { return static_cast<std::int32_t>(value >> scale.dropped); };
  const std::int32_t first = coarse(sum.min_sum(0));
  const std::int32_t column_step = coarse(sum.column_step());
  const std::int32_t row_step = coarse(sum.row_step());
  const Coarse number = hn::Iota(tag, 0);
  const Coarse ramp = hn::Add(hn::Mul(hn::And(number, hn::Set(tag, blocks_per_side - 1)), hn::Set(tag, column_step)),
                              hn::Mul(hn::ShiftRight<3>(number), hn::Set(tag, row_step)));
  const Coarse spread = hn::Set(tag, coarse(sum.spread()) + scale.excess);
  const Coarse one = hn::Set(tag, std::int32_t{1} << scale.kept);
  const Coarse beyond = hn::Set(tag, writes(kind) ? std::int32_t{1} << (task.lanes->field.width + scale.kept) : 0);
  const std::uint64_t group = (std::uint64_t{1} << count) - 1;

  Decided decided;
  for (std::size_t block = 0; block < blocks_per_tile; block += count) {
    if ((enabled >> block & group) == 0) continue;
    const auto column = static_cast<std::int32_t>(block % blocks_per_side);
    const auto row = static_cast<std::int32_t>(block / blocks_per_side);
    const Coarse low = hn::Add(ramp, hn::Set(tag, first + column * column_step + row * row_step));
    CoarseRange range{low, hn::Add(low, spread), hn::Zero(tag), hn::Zero(tag), one};
    if constexpr (!is_sign(kind)) {
      range.z_least = scale_bounds(task.lanes->least, block, scale.kept);
      range.z_greatest = scale_bounds(task.lanes->greatest, block, scale.kept);
    }
    decided.all |= bits_of_mask(tag, holds_throughout<kind>(range, sum.is_flat())) << block;
    decided.none |= bits_of_mask(tag, holds_nowhere<kind>(range)) << block;
    if constexpr (writes(kind))
      decided.fits |= bits_of_mask(tag, hn::And(at_least(low, hn::Zero(tag)), hn::Lt(range.high, beyond))) << block;
  }
  return decided;
}

template <LinearKind kind>
Decided decide(std::uint64_t enabled, const PlaneSum& sum, const LinearTask& task) {
  if constexpr (is_sign(kind)) {
    const bool positive = kind == LinearKind::not_negative;
    if (!sum.may_wrap() && sum.least() >= 0) return {positive ? enabled : 0, positive ? 0 : enabled};
    if (!sum.may_wrap() && sum.greatest() < 0) return {positive ? 0 : enabled, positive ? enabled : 0};
  }
  const std::optional<Scale> scale = find_scale<kind>(sum, task);
  return scale ? decide_coarsely<kind>(enabled, sum, task, *scale) : decide_exactly<kind>(enabled, sum, task);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#endif
