#include "host/view/screen_quadric.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hw/base/quotient.h"

namespace csgsim::view {

namespace {

__extension__ using Wide = __int128;

void include(Range& range, std::int64_t value) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

/// A*t^2 + B*t + C along a side of a rectangle.
struct Side {
  Wide a;
  Wide b;
  std::int32_t first;
  std::int32_t last;
  bool slants;  ///< whether a ridge or valley of the function may cross the side at a slant
};

/// Extends the range by the side's turning point: by the values at the adjacent integers and, if a ridge may cross the
/// side at a slant, by the value between them. Such a ridge may pass through an integer point inside the rectangle.
template <class At>
void include_turning_point(Range& range, const Side& side, const At& at) {
  if (side.a == 0) return;
  const Wide below = quotient_down(-side.b, 2 * side.a);
  for (const Wide t : {below, below + 1}) {
    if (t >= side.first && t <= side.last) include(range, at(static_cast<std::int32_t>(t)));
  }
  const Wide slope = 2 * side.a * below + side.b;
  if (!side.slants || slope == 0 || below < side.first || below >= side.last) return;
  const Wide size = side.a < 0 ? -side.a : side.a;
  const auto beyond = static_cast<std::int64_t>((slope * slope + 4 * size - 1) / (4 * size));
  include(range, at(static_cast<std::int32_t>(below)) + (side.a < 0 ? beyond : -beyond));
}

/// Upper bound of how far the extremum is beyond the value at a point with the gradient (by_x, by_y): half of the
/// gradient's square divided by the second derivatives of f, whose determinant is given.
std::int64_t beyond_place(const FixedQuadratic& f, Wide determinant, Wide by_x, Wide by_y) {
  const auto dx = static_cast<long double>(by_x);
  const auto dy = static_cast<long double>(by_y);
  const long double square = static_cast<long double>(f.yy) * dx * dx - static_cast<long double>(f.xy) * dx * dy +
                             static_cast<long double>(f.xx) * dy * dy;
  constexpr long double up = 1 + 1e-15L;
  return static_cast<std::int64_t>(std::ceil(std::abs(square / static_cast<long double>(determinant)) * up)) + 1;
}

/// Extends the range by the extremum if it is inside the rectangle.
void include_inner(Range& range, const FixedQuadratic& f, const PixelRect& rect) {
  const Wide determinant = 4 * Wide{f.xx} * f.yy - Wide{f.xy} * f.xy;
  if (determinant <= 0) return;  // a saddle or a valley, whose extremes are at the sides
  const Wide x =
      quotient_down(2 * (Wide{f.xy} * f.linear.b - 2 * Wide{f.yy} * f.linear.a) + determinant, 2 * determinant);
  const Wide y =
      quotient_down(2 * (Wide{f.xy} * f.linear.a - 2 * Wide{f.xx} * f.linear.b) + determinant, 2 * determinant);
  if (x < rect.x0 || x > rect.x1 || y < rect.y0 || y > rect.y1) return;
  const std::int64_t value = value_at(f, static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
  const std::int64_t slack = beyond_place(f, determinant, 2 * Wide{f.xx} * x + Wide{f.xy} * y + f.linear.a,
                                          2 * Wide{f.yy} * y + Wide{f.xy} * x + f.linear.b);
  if (f.xx < 0) {
    range.high = std::max(range.high, value + slack);
  } else {
    range.low = std::min(range.low, value - slack);
  }
}

/// Sets the depth ranges of both roots from the range of the discriminant where the middle plane is constant.
void set_depths(RootRanges& ranges, const ScreenQuadric& quadric, const Range& discriminant, unsigned fraction_bits) {
  const std::int64_t middle = quadric.middle.c >> fraction_bits;
  const Wide factor = quadric.factor.scaled();
  const unsigned shift = quadric.discriminant_shift + quadric.factor.fraction();
  const auto floor_of = [&](Wide value) { return static_cast<std::int64_t>(value >> shift); };
  const Wide least = factor * std::max<std::int64_t>(0, discriminant.low);
  const Wide most = factor * discriminant.high;
  ranges.near = {middle + floor_of(-most), middle + floor_of(-least)};
  ranges.far = {middle + floor_of(least) + 1, middle + floor_of(most) + 1};
}

}  // namespace

std::int64_t value_at(const FixedQuadratic& f, std::int32_t x, std::int32_t y) {
  const Wide sum = (Wide{f.xx} * x + Wide{f.xy} * y + f.linear.a) * x + (Wide{f.yy} * y + f.linear.b) * y + f.linear.c;
  return static_cast<std::int64_t>(sum);
}

Range range_over(const FixedQuadratic& f, const PixelRect& rect) {
  const std::int64_t first = value_at(f, rect.x0, rect.y0);
  Range range{first, first};
  for (const std::int32_t y : {rect.y0, rect.y1}) {
    for (const std::int32_t x : {rect.x0, rect.x1}) include(range, value_at(f, x, y));
    include_turning_point(range, {f.xx, Wide{f.xy} * y + f.linear.a, rect.x0, rect.x1, f.xy != 0},
                          [&](std::int32_t x) { return value_at(f, x, y); });
  }
  for (const std::int32_t x : {rect.x0, rect.x1}) {
    include_turning_point(range, {f.yy, Wide{f.xy} * x + f.linear.b, rect.y0, rect.y1, f.xy != 0},
                          [&](std::int32_t y) { return value_at(f, x, y); });
  }
  include_inner(range, f, rect);
  return range;
}

std::int64_t floor_root(std::int64_t value) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(value)));
  while (Wide{root} * root > value) --root;
  while (Wide{root + 1} * (root + 1) <= value) ++root;
  return root;
}

QuadricRole role_of(const ScreenQuadric& quadric, facet::QuadricSide side) {
  if (quadric.kind == ScreenQuadricKind::edge) return QuadricRole::edge;
  if (!quadric.eye_inside) return QuadricRole::between;
  return side.along_axis == quadric.eye_on_axis_nappe ? QuadricRole::until : QuadricRole::from;
}

unsigned TwoPowers::fraction() const {
  if (is_zero) return 0;
  return static_cast<unsigned>(std::max(0, -(signs == 0 ? first : second)));
}

std::int64_t TwoPowers::scaled() const {
  if (is_zero) return 0;
  const int up = static_cast<int>(fraction());
  const std::int64_t greater = std::int64_t{1} << (first + up);
  return signs == 0 ? greater : greater + signs * (std::int64_t{1} << (second + up));
}

RootRanges ranges_over(const ScreenQuadric& quadric, unsigned fraction_bits, const PixelRect& rect) {
  const Range discriminant = range_over(quadric.discriminant, rect);
  RootRanges ranges;
  ranges.discriminant = {discriminant.low >> quadric.discriminant_shift,
                         discriminant.high >> quadric.discriminant_shift};
  if (ranges.discriminant.high < 0) return ranges;
  if (quadric.kind == ScreenQuadricKind::paraboloid) {
    set_depths(ranges, quadric, discriminant, fraction_bits);
    return ranges;
  }
  const Range middle = range_over(quadric.middle, rect);
  const std::int64_t low = middle.low >> fraction_bits;
  const std::int64_t high = middle.high >> fraction_bits;
  const std::int64_t least_root = floor_root(std::max<std::int64_t>(0, ranges.discriminant.low));
  ranges.max_root = floor_root(ranges.discriminant.high);
  const std::int64_t one = std::int64_t{1} << quadric.unit;
  ranges.near = {low - ranges.max_root * one, high - least_root * one};
  ranges.far = {low + least_root * one + one, high + ranges.max_root * one + one};
  return ranges;
}

}  // namespace csgsim::view
