#include "sim/functional/edge.h"

#include <algorithm>

namespace csgsim::sim {

namespace {

struct Interval {
  std::int64_t from = 0;
  std::int64_t to = 0;
};

/// Rounded down; the divisor is positive.
std::int64_t floor_quotient(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

/// The t in [from, to) with slope * t + offset >= 0.
Interval not_negative(std::int64_t slope, std::int64_t offset, Interval within) {
  const auto [from, to] = within;
  if (slope > 0) return {std::clamp(-floor_quotient(offset, slope), from, to), to};
  if (slope < 0) return {from, std::clamp(floor_quotient(offset, -slope) + 1, from, to)};
  return offset >= 0 ? within : Interval{from, from};
}

/// The part of the rectangle that bounds its intersection with the half-plane.
Rect bounds_within(const Rect& rect, const HalfPlane& half_plane) {
  const auto [a, b, c] = half_plane;
  const std::int64_t highest_of_a = std::max(a * rect.x0, a * (static_cast<std::int64_t>(rect.x1) - 1));
  const std::int64_t highest_of_b = std::max(b * rect.y0, b * (static_cast<std::int64_t>(rect.y1) - 1));
  const Interval x = not_negative(a, highest_of_b + c, {rect.x0, rect.x1});
  const Interval y = not_negative(b, highest_of_a + c, {rect.y0, rect.y1});
  const Rect part{static_cast<std::uint32_t>(x.from), static_cast<std::uint32_t>(y.from),
                  static_cast<std::uint32_t>(x.to), static_cast<std::uint32_t>(y.to)};
  return part.empty() ? Rect{} : part;
}

/// floor((b * y + c) / |a|) row after row, without a division a row.
class RowQuotient {
 public:
  RowQuotient(const HalfPlane& half_plane, std::uint32_t row)
      : divisor_(half_plane.a < 0 ? -half_plane.a : half_plane.a) {
    const std::int64_t first = half_plane.b * row + half_plane.c;
    quotient_ = floor_quotient(first, divisor_);
    remainder_ = first - quotient_ * divisor_;
    quotient_step_ = floor_quotient(half_plane.b, divisor_);
    remainder_step_ = half_plane.b - quotient_step_ * divisor_;
  }
  [[nodiscard]] std::int64_t value() const { return quotient_; }
  void next_row() {
    quotient_ += quotient_step_;
    remainder_ += remainder_step_;
    if (remainder_ < divisor_) return;
    remainder_ -= divisor_;
    ++quotient_;
  }

 private:
  std::int64_t divisor_;
  std::int64_t quotient_ = 0;
  std::int64_t remainder_ = 0;
  std::int64_t quotient_step_ = 0;
  std::int64_t remainder_step_ = 0;
};

bool holds_throughout(const Rect& rect, const HalfPlane& half_plane) {
  const auto [a, b, c] = half_plane;
  const std::int64_t lowest_of_a = std::min(a * rect.x0, a * (static_cast<std::int64_t>(rect.x1) - 1));
  const std::int64_t lowest_of_b = std::min(b * rect.y0, b * (static_cast<std::int64_t>(rect.y1) - 1));
  return lowest_of_a + lowest_of_b + c >= 0;
}

}  // namespace

void clip(BitPlane& plane, const HalfPlane& half_plane) {
  const Rect old = plane.bounds();
  const Rect part = bounds_within(old, half_plane);
  const bool whole = holds_throughout(part, half_plane);
  if (part.empty() || (whole && (plane.solid() || (part.x0 == old.x0 && part.x1 == old.x1)))) {
    plane.narrow(part);
    return;
  }
  if (plane.solid()) {
    plane.narrow(part);
    plane.materialise();
  }
  const Cells cells(part);
  // Where a is 0 every row is whole: the interval is that of the columns.
  RowQuotient quotient(half_plane.a == 0 ? HalfPlane{1, 0, 0} : half_plane, part.y0);
  for (std::uint32_t row = part.y0; row < part.y1; ++row, quotient.next_row()) {
    const std::int64_t from = half_plane.a > 0 ? -quotient.value() : part.x0;
    const std::int64_t to = half_plane.a < 0 ? quotient.value() + 1 : part.x1;
    for (std::uint32_t column = cells.column; column < cells.column + cells.columns; ++column) {
      const std::int64_t first = static_cast<std::int64_t>(column) * word_bits;
      plane.set_word(row, column, plane.word(row, column) & bits_between(from - first, to - first));
    }
  }
  plane.narrow(part);
}

}  // namespace csgsim::sim
