#include "sim/functional/quadratic_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim/functional/quadratic_kernels.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

#include "sim/functional/block_lanes-inl.h"
#include "sim/functional/bytes-inl.h"
#include "sim/functional/linear_test-inl.h"
#include "sim/functional/mask_bits-inl.h"
#include "sim/functional/quadratic_sum.h"

HWY_BEFORE_NAMESPACE();
namespace csgsim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr bool adds(LinearKind kind) { return kind == LinearKind::plus || kind == LinearKind::minus; }
constexpr bool tests(LinearKind kind) { return !writes(kind) && !adds(kind); }

// Decisions for whole blocks.

enum class Alike : std::uint8_t { no, all, none };

/// Whether the test of the kind holds for every pair of f and z in their ranges, for none, or neither.
template <LinearKind kind>
Alike decide(const QuadraticSum::Range& f, std::int64_t z_least, std::int64_t z_greatest) {
  using enum LinearKind;
  const auto choose = [](bool all, bool none) { return all ? Alike::all : none ? Alike::none : Alike::no; };
  if constexpr (kind == not_negative || kind == greater_or_equal)
    return choose(f.least >= z_greatest, f.greatest < z_least);
  else if constexpr (kind == negative || kind == less)
    return choose(f.greatest < z_least, f.least >= z_greatest);
  else if constexpr (kind == greater)
    return choose(f.least > z_greatest, f.greatest <= z_least);
  else if constexpr (kind == less_or_equal)
    return choose(f.greatest <= z_least, f.least > z_greatest);
  else
    return choose(f.least == f.greatest && z_least == z_greatest && f.least == z_least,
                  f.least > z_greatest || f.greatest < z_least);
}

/// Decides for `width` x `height` pixels from the first of `sum` on. Their sums must fit the width.
template <LinearKind kind>
Alike decide(const QuadraticTask& task, const QuadraticSum& sum, std::uint32_t width, std::uint32_t height,
             std::int64_t z_least, std::int64_t z_greatest) {
  if (!sum.can_bound()) return Alike::no;
  const QuadraticSum::Range range = sum.range(width, height);
  const std::int64_t limit = std::int64_t{1} << (task.width - 1);
  if (range.least < -limit || range.greatest >= limit) return Alike::no;
  const unsigned shift = task.shift;
  return decide<kind>({range.least >> shift, range.greatest >> shift}, z_least, z_greatest);
}

// Kernels that process a block pixel by pixel.

using SumTag = hn::CappedTag<std::int64_t, block_side>;
using Sums = hn::Vec<SumTag>;

/// F at the pixels of a block, one block after the other.
class BlockF {
 public:
  explicit BlockF(const QuadraticTask& task)
      : sign_bits_(static_cast<int>(word_bits - task.width)), shift_(static_cast<int>(task.shift)) {
    const QuadraticSum& sum = task.sum;
    for (std::uint64_t i = 0; i < block_pixels; ++i) {
      const std::uint64_t x = i % block_side;
      const std::uint64_t y = i / block_side;
      squares_[i] = static_cast<std::int64_t>((sum.xx() * x + sum.xy() * y) * x + sum.yy() * y * y);
    }
  }

  /// `sum` starts at the block's first pixel.
  HWY_INLINE void evaluate(const QuadraticSum& sum) {
    constexpr SumTag tag;
    HWY_ALIGN std::int64_t columns[block_side];
    for (std::uint64_t x = 0; x < block_side; ++x) columns[x] = static_cast<std::int64_t>(sum.a() * x);
    wrapped_ = 0;
    std::uint64_t row = sum.c();
    for (std::size_t first = 0; first < block_pixels; first += block_side, row += sum.b()) {
      const Sums start = hn::Set(tag, static_cast<std::int64_t>(row));
      for (std::size_t x = 0; x < block_side; x += hn::Lanes(tag)) {
        const Sums exact = hn::Add(hn::Add(start, hn::Load(tag, columns + x)), hn::Load(tag, squares_ + first + x));
        const Sums kept = hn::ShiftRightSame(hn::ShiftLeftSame(exact, sign_bits_), sign_bits_);
        wrapped_ |= bits_of_mask(tag, hn::Ne(kept, exact)) << (first + x);
        hn::Store(hn::ShiftRightSame(kept, shift_), tag, values_ + first + x);
      }
    }
  }

  /// The bits of F, in two's complement.
  [[nodiscard]] const std::uint64_t* bits() const { return reinterpret_cast<const std::uint64_t*>(values_); }
  [[nodiscard]] HWY_INLINE Sums at(std::size_t from) const { return hn::Load(SumTag(), values_ + from); }
  /// Pixels whose sum does not fit the width.
  [[nodiscard]] std::uint64_t wrapped() const { return wrapped_; }

 private:
  HWY_ALIGN std::int64_t squares_[block_pixels];
  HWY_ALIGN std::int64_t values_[block_pixels];
  int sign_bits_;
  int shift_;
  std::uint64_t wrapped_ = 0;
};

template <LinearKind kind>
std::uint64_t pixels_where_negative(const BlockF& f) {
  std::uint64_t holds = 0;
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(SumTag()))
    holds |= bits_of_mask(SumTag(), test<kind>(f.at(from), hn::Zero(SumTag()))) << from;
  return holds;
}

/// The value written where E is 1 and the test holds: F or, for the kinds that add, F and z combined.
template <LinearKind kind>
HWY_INLINE Sums written(Sums f, Sums z) {
  if constexpr (kind == LinearKind::plus)
    return hn::Add(f, z);
  else if constexpr (kind == LinearKind::minus)
    return hn::Sub(f, z);
  else
    return f;
}

/// Executes the task on a block of lanes. Returns the pixels that stay enabled.
template <LinearKind kind>
std::uint64_t execute_on_lanes(const BlockF& f, Lanes& lanes, unsigned block, std::uint64_t enabled) {
  constexpr SumTag tag;
  constexpr hn::RebindToUnsigned<SumTag> unsigned_tag;
  constexpr hn::Rebind<std::uint32_t, SumTag> lane_tag;
  if (lanes.is_constant(block)) fill(lanes, block);
  const Sums low_bits = hn::Set(tag, (std::int64_t{1} << lanes.field.width) - 1);
  std::uint64_t holds = 0;
  std::uint64_t misfits = 0;
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
    std::uint32_t* const values = lanes.block(block) + from;
    const Sums z = hn::BitCast(tag, hn::PromoteTo(unsigned_tag, hn::LoadU(lane_tag, values)));
    const auto meets = test<kind>(f.at(from), z);
    holds |= bits_of_mask(tag, meets) << from;
    if constexpr (!tests(kind)) {
      const auto here = hn::And(mask_of_bits(tag, enabled >> from), meets);
      const Sums number = written<kind>(f.at(from), z);
      const Sums low = hn::And(number, low_bits);
      hn::StoreU(hn::TruncateTo(lane_tag, hn::BitCast(unsigned_tag, hn::IfThenElse(here, low, z))), lane_tag, values);
      if constexpr (writes(kind)) misfits |= bits_of_mask(tag, hn::And(here, hn::Ne(low, number))) << from;
    }
  }
  if constexpr (!tests(kind)) bound(lanes, block);
  return tests(kind) ? enabled & holds : enabled & ~misfits;
}

/// Pixels at which F has a 1 at bit `bit` or above.
std::uint64_t pixels_past(const BlockF& f, std::size_t bit) {
  constexpr hn::RebindToUnsigned<SumTag> tag;
  std::uint64_t past = 0;
  for (std::size_t from = 0; from < block_pixels; from += hn::Lanes(tag)) {
    const auto rest = hn::ShiftRightSame(hn::BitCast(tag, f.at(from)), static_cast<int>(bit));
    past |= bits_of_mask(tag, hn::Ne(rest, hn::Zero(tag))) << from;
  }
  return past;
}

/// Executes the task on a block of a field in planes: F's bits are words of the block's pixels, which are stored or
/// added bit by bit. Returns the pixels that stay enabled.
template <LinearKind kind>
std::uint64_t execute_on_planes(const BlockF& f, std::span<TileBits* const> planes, const TileShape& shape,
                                unsigned block, std::uint64_t enabled) {
  std::array<std::uint64_t, isa::max_wide_field_width> f_bits;
  extract_words(hn::RebindToUnsigned<SumTag>(), f.bits(), 0, std::span(f_bits).first(planes.size()));
  std::uint64_t carry = kind == LinearKind::minus ? ~std::uint64_t{0} : 0;
  for (std::size_t bit = 0; bit < planes.size(); ++bit) {
    const std::uint64_t old = planes[bit]->word(block, shape);
    std::uint64_t number = f_bits[bit];
    if constexpr (adds(kind)) {
      const std::uint64_t added = kind == LinearKind::minus ? ~old : old;
      const std::uint64_t half = number ^ added;
      const std::uint64_t next = (number & added) | (half & carry);
      number = half ^ carry;
      carry = next;
    }
    planes[bit]->set_word(block, (old & ~enabled) | (number & enabled), shape);
  }
  if constexpr (adds(kind)) return enabled;
  return enabled & ~pixels_past(f, planes.size());
}

template <LinearKind kind>
std::uint64_t execute_on_block(const BlockF& f, const QuadraticTask& task, const TileShape& shape, unsigned block,
                               std::uint64_t enabled) {
  if constexpr (is_sign(kind)) return enabled & pixels_where_negative<kind>(f);
  if constexpr (kind == LinearKind::load || adds(kind))
    if (!task.planes.empty()) return execute_on_planes<kind>(f, task.planes, shape, block, enabled);
  if constexpr (!is_sign(kind)) return execute_on_lanes<kind>(f, *task.lanes, block, enabled);
}

/// The blocks that remain undecided after tests for the whole tile and for each block.
template <LinearKind kind>
std::uint64_t decide_blocks(const EnabledPixels& pixels, const QuadraticTask& task) {
  TileBits& enable = pixels.enable;
  if constexpr (!tests(kind)) {
    return enable.any();
  } else {
    if (is_sign(kind)) {
      const Alike alike = decide<kind>(task, task.sum, pixels.shape.width(), pixels.shape.height(), 0, 0);
      if (alike == Alike::none) enable.clear();
      if (alike != Alike::no) return 0;
    }
    std::uint64_t open = 0;
    each_bit(enable.any(), [&](unsigned block) {
      const std::uint64_t one = std::uint64_t{1} << block;
      const auto [x, y] = std::pair(block % blocks_per_side * block_side, block / blocks_per_side * block_side);
      const std::int64_t z_least = is_sign(kind) ? 0 : task.lanes->least[block];
      const std::int64_t z_greatest = is_sign(kind) ? 0 : task.lanes->greatest[block];
      const Alike alike = decide<kind>(task, task.sum.from(x, y), std::min(block_side, pixels.shape.width() - x),
                                       std::min(block_side, pixels.shape.height() - y), z_least, z_greatest);
      if (alike == Alike::none) enable.clear_blocks(one);
      if (alike == Alike::no) open |= one;
    });
    return open;
  }
}

template <LinearKind kind>
LinearResult run(const EnabledPixels& pixels, const QuadraticTask& task) {
  const std::uint64_t open =
      pixels.decide == Decide::by_block ? decide_blocks<kind>(pixels, task) : pixels.enable.any();
  const auto examined = static_cast<std::uint64_t>(std::popcount(open));
  pixels.work.words += examined;
  pixels.work.lanes += examined * block_pixels;
  LinearResult result;
  if (open != 0) {
    BlockF f(task);
    each_bit(open, [&](unsigned block) {
      const std::uint64_t enabled = pixels.enable.word(block, pixels.shape);
      f.evaluate(task.sum.from(block % blocks_per_side * block_side, block / blocks_per_side * block_side));
      result.overflows += static_cast<std::uint64_t>(std::popcount(f.wrapped() & enabled));
      pixels.enable.set_word(block, execute_on_block<kind>(f, task, pixels.shape, block, enabled), pixels.shape);
    });
  }
  result.enabled = count(pixels.enable, pixels.shape);
  return result;
}

LinearResult run_any(const EnabledPixels& pixels, const QuadraticTask& task) {
  using enum LinearKind;
  switch (task.kind) {
    case not_negative: return run<not_negative>(pixels, task);
    case negative: return run<negative>(pixels, task);
    case greater_or_equal: return run<greater_or_equal>(pixels, task);
    case greater: return run<greater>(pixels, task);
    case less_or_equal: return run<less_or_equal>(pixels, task);
    case less: return run<less>(pixels, task);
    case equal: return run<equal>(pixels, task);
    case load: return run<load>(pixels, task);
    case keep_max: return run<keep_max>(pixels, task);
    case keep_min: return run<keep_min>(pixels, task);
    case plus: return run<plus>(pixels, task);
    case minus: return run<minus>(pixels, task);
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

LinearResult run_quadratic(const EnabledPixels& pixels, const QuadraticTask& task) {
  return HWY_DYNAMIC_DISPATCH(run_any)(pixels, task);
}

}  // namespace csgsim::functional
#endif
