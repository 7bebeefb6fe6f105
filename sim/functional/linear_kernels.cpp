#include "sim/functional/linear_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/functional/linear_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <bit>

#include "sim/functional/block_lanes-inl.h"
#include "sim/functional/linear_decide-inl.h"
#include "sim/functional/linear_test-inl.h"
#include "sim/functional/mask_bits-inl.h"
#include "sim/functional/plane_sum.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Kernels that process a block pixel by pixel if F minus F at the block's first pixel fits 32 bits.

using NarrowTag = hn::RebindToSigned<NumberTag>;
using Narrow = hn::Vec<NarrowTag>;

/// F at the pixels of a block.
class NarrowF {
 public:
  NarrowF(const isa::Linear& linear) : shift_(linear.shift) {
    constexpr NarrowTag tag;
    const Narrow a = hn::Set(tag, static_cast<std::int32_t>(linear.a));
    const Narrow b = hn::Set(tag, static_cast<std::int32_t>(linear.b));
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
      const Narrow number = hn::Iota(tag, static_cast<std::int32_t>(from));
      const Narrow x = hn::And(number, hn::Set(tag, block_side - 1));
      hn::Store(hn::Add(hn::Mul(a, x), hn::Mul(b, hn::ShiftRight<3>(number))), tag, ramp_ + from);
    }
  }
  /// Sets the block's sum at its first pixel.
  HWY_INLINE void begin(std::int64_t sum) {
    whole_ = static_cast<std::int32_t>(sum >> shift_);
    fraction_ = static_cast<std::int32_t>(sum & ((std::int64_t{1} << shift_) - 1));
  }
  [[nodiscard]] HWY_INLINE Narrow at(std::size_t from) const {
    constexpr NarrowTag tag;
    const Narrow rest = hn::Add(hn::Load(tag, ramp_ + from), hn::Set(tag, fraction_));
    return hn::Add(hn::ShiftRightSame(rest, shift_), hn::Set(tag, whole_));
  }

 private:
  HWY_ALIGN std::int32_t ramp_[block_pixels];
  int shift_;
  std::int32_t whole_ = 0;
  std::int32_t fraction_ = 0;
};

template <LinearKind kind>
HWY_INLINE std::uint64_t narrow_test(const NarrowF& f, const Lanes* lanes, unsigned block) {
  constexpr NarrowTag tag;
  if constexpr (is_sign(kind)) {
    return test_block(
        [&](std::size_t from) { return hn::RebindMask(NumberTag(), test<kind>(f.at(from), hn::Zero(tag))); });
  } else {
    const BlockNumbers z(*lanes, block);
    return test_block([&](std::size_t from) {
      return hn::RebindMask(NumberTag(), test<kind>(f.at(from), hn::BitCast(tag, z.at(from))));
    });
  }
}

/// Writes F, which must fit the field, where the test holds and the pixel is enabled. If `all`, the test holds at all
/// pixels.
template <LinearKind kind>
HWY_INLINE void narrow_write(const NarrowF& f, Lanes& lanes, unsigned block, std::uint64_t enabled, bool all) {
  constexpr NarrowTag tag;
  std::uint32_t* const values = lanes.block(block);
  if (all && enabled == ~std::uint64_t{0}) {
    for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag))
      hn::StoreU(hn::BitCast(NumberTag(), f.at(from)), NumberTag(), values + from);
    return;
  }
  if (lanes.is_constant(block)) fill(lanes, block);
  if (all || kind == LinearKind::load) {
    write_block(values, enabled, [&](std::size_t from, Numbers) { return hn::BitCast(NumberTag(), f.at(from)); });
  } else if constexpr (kind == LinearKind::keep_max) {
    write_block(values, enabled, [&](std::size_t from, Numbers old) {
      return hn::BitCast(NumberTag(), hn::Max(f.at(from), hn::BitCast(tag, old)));
    });
  } else {
    write_block(values, enabled, [&](std::size_t from, Numbers old) {
      return hn::BitCast(NumberTag(), hn::Min(f.at(from), hn::BitCast(tag, old)));
    });
  }
}

/// Updates the bounds after narrow_write.
template <LinearKind kind>
HWY_INLINE void narrow_bounds(Lanes& lanes, unsigned block, bool full, bool all, std::uint32_t low,
                              std::uint32_t high) {
  std::uint32_t& least = lanes.least[block];
  std::uint32_t& greatest = lanes.greatest[block];
  if (full && (all || kind == LinearKind::load)) {
    least = low;
    greatest = high;
  } else if (all || kind == LinearKind::load) {
    widen(lanes, block, low, high);
  } else if constexpr (kind == LinearKind::keep_max) {
    greatest = std::max(greatest, high);
    if (full) least = std::max(least, low);
  } else {
    least = std::min(least, low);
    if (full) greatest = std::min(greatest, high);
  }
}

// Kernels that process a block pixel by pixel for any F.

using WideTag = hn::ScalableTag<std::int64_t>;
using Wide = hn::Vec<WideTag>;

/// Differences, modulo 2^64, between the sums at the pixels of a block and the sum at its first pixel.
struct WideRamp {
  HWY_ALIGN std::int64_t values[block_pixels];

  explicit WideRamp(const isa::Linear& linear) {
    for (std::uint64_t i = 0; i < block_pixels; ++i)
      values[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(linear.a) * (i % block_side) +
                                            static_cast<std::uint64_t>(linear.b) * (i / block_side));
  }
};

struct Outcome {
  std::uint64_t enable = 0;
  std::uint64_t overflows = 0;
};

/// `first` is the sum at the block's first pixel, modulo 2^64.
template <LinearKind kind>
Outcome wide_block(const LinearTask& task, const WideRamp& ramp, std::int64_t first, unsigned block,
                   std::uint64_t enabled) {
  constexpr WideTag tag;
  constexpr hn::RebindToUnsigned<WideTag> unsigned_tag;
  constexpr hn::Rebind<std::uint32_t, WideTag> lane_tag;
  const int sign_bits = static_cast<int>(word_bits - task.linear.width);
  const int shift = task.linear.shift;
  Lanes* const lanes = task.lanes;
  if (!is_sign(kind) && lanes->is_constant(block)) fill(*lanes, block);

  std::uint64_t holds = 0;
  std::uint64_t misfits = 0;
  std::uint64_t wrapped = 0;
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
    const Wide sum = hn::Add(hn::Set(tag, first), hn::Load(tag, ramp.values + from));
    const Wide kept = hn::ShiftRightSame(hn::ShiftLeftSame(sum, sign_bits), sign_bits);
    wrapped |= bits_of_mask(tag, hn::Ne(kept, sum)) << from;
    const Wide f = hn::ShiftRightSame(kept, shift);
    if constexpr (is_sign(kind)) {
      holds |= bits_of_mask(tag, test<kind>(f, hn::Zero(tag))) << from;
    } else {
      std::uint32_t* const values = lanes->block(block) + from;
      const Wide z = hn::BitCast(tag, hn::PromoteTo(unsigned_tag, hn::LoadU(lane_tag, values)));
      const auto meets = test<kind>(f, z);
      if constexpr (writes(kind)) {
        const Wide low_bits = hn::Set(tag, (std::int64_t{1} << lanes->field.width) - 1);
        const auto written = hn::And(mask_of_bits(tag, enabled >> from), meets);
        const Wide result = hn::IfThenElse(written, hn::And(f, low_bits), z);
        hn::StoreU(hn::TruncateTo(lane_tag, hn::BitCast(unsigned_tag, result)), lane_tag, values);
        misfits |= bits_of_mask(tag, hn::And(written, hn::Ne(hn::And(f, low_bits), f))) << from;
      } else {
        holds |= bits_of_mask(tag, meets) << from;
      }
    }
  }
  if constexpr (writes(kind)) bound(*lanes, block);
  return {enabled & (writes(kind) ? ~misfits : holds), static_cast<std::uint64_t>(std::popcount(wrapped & enabled))};
}

template <LinearKind kind>
std::uint64_t wide_blocks(const EnabledPixels& pixels, const LinearTask& task, const PlaneSum& sum,
                          std::uint64_t blocks) {
  if (blocks == 0) return 0;
  const WideRamp ramp(task.linear);
  std::uint64_t overflows = 0;
  each_bit(blocks, [&](unsigned block) {
    const Outcome outcome =
        wide_block<kind>(task, ramp, sum.first_sum(block), block, pixels.enable.word(block, pixels.shape));
    pixels.enable.set_word(block, outcome.enable, pixels.shape);
    overflows += outcome.overflows;
  });
  return overflows;
}

template <LinearKind kind>
void narrow_blocks(const EnabledPixels& pixels, const LinearTask& task, const PlaneSum& sum, std::uint64_t blocks,
                   std::uint64_t all) {
  if (blocks == 0) return;
  NarrowF f(task.linear);
  each_bit(blocks, [&](unsigned block) {
    const std::uint64_t enabled = pixels.enable.word(block, pixels.shape);
    f.begin(sum.first_sum(block));
    if constexpr (writes(kind)) {
      const bool everywhere = kind == LinearKind::load || (all >> block & 1U) != 0;
      const bool full = (pixels.enable.full() >> block & 1U) != 0;
      narrow_write<kind>(f, *task.lanes, block, full ? ~std::uint64_t{0} : enabled, everywhere);
      const std::int64_t low = sum.min_sum(block) >> task.linear.shift;
      const std::int64_t high = (sum.min_sum(block) + sum.spread()) >> task.linear.shift;
      narrow_bounds<kind>(*task.lanes, block, full, everywhere, static_cast<std::uint32_t>(low),
                          static_cast<std::uint32_t>(high));
    } else {
      pixels.enable.set_word(block, enabled & narrow_test<kind>(f, task.lanes, block), pixels.shape);
    }
  });
}

template <LinearKind kind>
LinearResult run(const EnabledPixels& pixels, const LinearTask& task, std::uint32_t enabled) {
  const PlaneSum sum(task.linear, pixels.shape);
  const bool may_decide = pixels.decide == Decide::by_block && !sum.is_huge();
  const Decided decided = may_decide ? decide<kind>(pixels.enable.any(), sum, task) : Decided{};
  std::uint64_t open = pixels.enable.any() & ~decided.none;
  const std::uint64_t dropped = pixels.enable.any() & decided.none;
  std::uint64_t narrow = 0;
  if constexpr (writes(kind)) {
    if (sum.is_narrow() && task.lanes->field.width <= PlaneSum::narrow_bits) narrow = open & decided.fits;
  } else {
    pixels.enable.clear_blocks(decided.none);
    open &= ~decided.all;
    const bool is_narrow = is_sign(kind) || task.lanes->field.width <= PlaneSum::narrow_bits;
    if (may_decide && sum.is_narrow() && is_narrow) narrow = open & ~decided.may_wrap;
  }
  const auto examined = static_cast<std::uint64_t>(std::popcount(open));
  pixels.work.words += examined;
  pixels.work.lanes += examined * block_pixels;
  narrow_blocks<kind>(pixels, task, sum, narrow, decided.all);
  LinearResult result{0, enabled};
  result.overflows = wide_blocks<kind>(pixels, task, sum, open & ~narrow);
  const bool keeps_enable = writes(kind) ? (open & ~narrow) == 0 : open == 0 && dropped == 0;
  if (!keeps_enable) result.enabled = count(pixels.enable, pixels.shape);
  return result;
}

LinearResult run_any(const EnabledPixels& pixels, const LinearTask& task, std::uint32_t enabled) {
  using enum LinearKind;
  switch (task.kind) {
    case not_negative: return run<not_negative>(pixels, task, enabled);
    case negative: return run<negative>(pixels, task, enabled);
    case greater_or_equal: return run<greater_or_equal>(pixels, task, enabled);
    case greater: return run<greater>(pixels, task, enabled);
    case less_or_equal: return run<less_or_equal>(pixels, task, enabled);
    case less: return run<less>(pixels, task, enabled);
    case equal: return run<equal>(pixels, task, enabled);
    case load: return run<load>(pixels, task, enabled);
    case keep_max: return run<keep_max>(pixels, task, enabled);
    case keep_min: return run<keep_min>(pixels, task, enabled);
    case plus:
    case minus: break;  // only in run_quadratic
  }
  return {};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::functional {

HWY_EXPORT(run_any);

LinearResult run_linear(const EnabledPixels& pixels, const LinearTask& task, std::uint32_t enabled_count) {
  return HWY_DYNAMIC_DISPATCH(run_any)(pixels, task, enabled_count);
}

}  // namespace csgsim::functional
#endif
