#include "sim/functional/linear_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/functional/linear_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <bit>

#include "sim/functional/mask_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::sim {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<std::uint64_t>;
using SignedTag = hn::RebindToSigned<Tag>;
using LaneTag = hn::Rebind<std::uint32_t, Tag>;
using Vector = hn::Vec<Tag>;

/// Signed comparison of vectors of two's complement numbers.
HWY_INLINE hn::Mask<Tag> greater(Vector left, Vector right) {
  constexpr SignedTag signed_tag;
  return hn::RebindMask(Tag(), hn::Gt(hn::BitCast(signed_tag, left), hn::BitCast(signed_tag, right)));
}

template <LinearKind kind, bool wraps>
std::uint64_t run(const WordBlock& enable, const LinearTask& task) {
  constexpr Tag tag;
  constexpr SignedTag signed_tag;
  constexpr LaneTag lane_tag;
  const std::size_t count = hn::Lanes(tag);

  HWY_ALIGN std::uint64_t ramp_values[word_bits];
  for (std::size_t i = 0; i < count; ++i) ramp_values[i] = task.a * i;
  const Vector ramp = hn::Load(tag, ramp_values);
  const Vector step = hn::Set(tag, task.a * count);
  const Vector bias = hn::Set(tag, task.bias);
  const Vector whole = hn::Set(tag, ~std::uint64_t{0} << task.shift);
  const Vector too_big = hn::Set(tag, ~std::uint64_t{0} << task.field_width);
  const int shift = static_cast<int>(task.shift);
  const int sign_bits = static_cast<int>(word_bits - task.width);
  const std::uint64_t lane_bits = count == word_bits ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;

  std::uint64_t overflows = 0;
  for (std::size_t row = 0; row < enable.rows; ++row) {
    const std::uint64_t row_start = task.start + task.b * row;
    for (std::size_t column = 0; column < enable.columns; ++column) {
      const std::size_t index = row * enable.stride + column;
      const std::uint64_t enabled = enable.words[index];
      if (enabled == 0) continue;
      const std::size_t first = static_cast<std::size_t>(std::countr_zero(enabled)) & ~(count - 1);
      const std::size_t end = word_bits - static_cast<std::size_t>(std::countl_zero(enabled));
      std::uint32_t* const lanes = kind == LinearKind::sign ? nullptr : task.lanes + index * word_bits;

      Vector sum = hn::Add(ramp, hn::Set(tag, row_start + task.a * (column * word_bits + first)));
      std::uint64_t holds = 0;    // sign, compare, equal
      std::uint64_t misfits = 0;  // load, keep
      for (std::size_t from = first; from < end; from += count, sum = hn::Add(sum, step)) {
        Vector s = sum;
        if constexpr (wraps) {
          const auto high = hn::ShiftLeftSame(hn::BitCast(signed_tag, sum), sign_bits);
          s = hn::BitCast(tag, hn::ShiftRightSame(high, sign_bits));
          const std::uint64_t differ = bits_of_mask(tag, hn::Ne(s, sum)) & (enabled >> from) & lane_bits;
          overflows += static_cast<std::uint64_t>(std::popcount(differ));
        }
        if constexpr (kind == LinearKind::sign) {
          holds |= bits_of_mask(tag, greater(hn::Add(s, bias), hn::Zero(tag))) << from;
        } else {
          const Vector z = hn::PromoteTo(tag, hn::LoadU(lane_tag, lanes + from));
          const Vector shifted = hn::ShiftLeftSame(z, shift);
          if constexpr (kind == LinearKind::compare) {
            holds |= bits_of_mask(tag, greater(hn::Add(s, bias), shifted)) << from;
          } else if constexpr (kind == LinearKind::equal) {
            holds |= bits_of_mask(tag, hn::Eq(hn::And(s, whole), shifted)) << from;
          } else {
            hn::Mask<Tag> written = mask_of_bits(tag, enabled >> from);
            if constexpr (kind == LinearKind::keep_max) written = hn::And(written, greater(hn::Add(s, bias), shifted));
            if constexpr (kind == LinearKind::keep_min) written = hn::And(written, greater(shifted, s));
            // F of a negative S has its high bits set and never fits, so a shift that brings in zeros will do.
            const Vector f = hn::ShiftRightSame(s, shift);
            const Vector excess = hn::And(f, too_big);
            const Vector result = hn::IfThenElse(written, hn::AndNot(too_big, f), z);
            hn::StoreU(hn::TruncateTo(lane_tag, result), lane_tag, lanes + from);
            misfits |= bits_of_mask(tag, hn::And(written, hn::Ne(excess, hn::Zero(tag)))) << from;
          }
        }
      }
      constexpr bool compares = kind == LinearKind::sign || kind == LinearKind::compare || kind == LinearKind::equal;
      const std::uint64_t cleared = compares ? (task.negate ? holds : ~holds) : misfits;
      enable.words[index] = enabled & ~cleared;
    }
  }
  return overflows;
}

template <LinearKind kind>
std::uint64_t run_kind(const WordBlock& enable, const LinearTask& task) {
  return task.wraps ? run<kind, true>(enable, task) : run<kind, false>(enable, task);
}

std::uint64_t run_any(const WordBlock& enable, const LinearTask& task) {
  switch (task.kind) {
    case LinearKind::sign: return run_kind<LinearKind::sign>(enable, task);
    case LinearKind::compare: return run_kind<LinearKind::compare>(enable, task);
    case LinearKind::equal: return run_kind<LinearKind::equal>(enable, task);
    case LinearKind::load: return run_kind<LinearKind::load>(enable, task);
    case LinearKind::keep_max: return run_kind<LinearKind::keep_max>(enable, task);
    case LinearKind::keep_min: return run_kind<LinearKind::keep_min>(enable, task);
  }
  return 0;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace csgsim::sim
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace csgsim::sim {

HWY_EXPORT(run_any);

std::uint64_t run_linear(const WordBlock& enable, const LinearTask& task) {
  return HWY_DYNAMIC_DISPATCH(run_any)(enable, task);
}

}  // namespace csgsim::sim
#endif
