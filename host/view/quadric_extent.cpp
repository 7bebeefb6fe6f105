#include "host/view/quadric_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgsim::view {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A quadric near a point, in doubles, with bounds that also hold for the unrounded quadric.
struct Around {
  double unit;         ///< unit of D's root, depth steps
  double d;            ///< lower bound of D at the point
  double from_middle;  ///< upper bound of the distance between the point and the middle, in depth steps
  double middle;       ///< middle at the point
  double least_polar;  ///< minimum over the pixels of D's polar form about the point, see required_growth
  double depth_error;  ///< error of a rounded depth where the unrounded D is not negative, depth steps
  double error;        ///< error of D
};

Around around(const ScreenQuadric& quadric, const glm::dvec3& inside, const View& view, const PixelRect& pixels) {
  const FixedQuadratic& f = quadric.discriminant;
  const double scale = std::ldexp(1.0, -static_cast<int>(quadric.discriminant_shift));
  const auto value = [&](std::int64_t coefficient) { return static_cast<double>(coefficient) * scale; };
  const double slope_x = 2.0 * value(f.xx) * inside.x + value(f.xy) * inside.y + value(f.linear.a);
  const double slope_y = 2.0 * value(f.yy) * inside.y + value(f.xy) * inside.x + value(f.linear.b);
  const double d = (value(f.xx) * inside.x + value(f.xy) * inside.y + value(f.linear.a)) * inside.x +
                   (value(f.yy) * inside.y + value(f.linear.b)) * inside.y + value(f.linear.c);
  const double ulp = std::ldexp(1.0, -static_cast<int>(view.sampling.fraction_bits));
  Around here{};
  here.unit = std::ldexp(1.0, static_cast<int>(quadric.unit));
  here.error = 1.01 * quadric.discriminant_error + 1e-9 * std::abs(d);
  here.d = d - here.error;
  here.middle = (static_cast<double>(quadric.middle.a) * inside.x + static_cast<double>(quadric.middle.b) * inside.y +
                 static_cast<double>(quadric.middle.c)) *
                ulp;
  here.from_middle = std::abs(inside.z - here.middle) + quadric.middle_error;
  here.least_polar = unlimited;
  for (const std::int32_t x : {pixels.x0, pixels.x1}) {
    for (const std::int32_t y : {pixels.y0, pixels.y1}) {
      here.least_polar = std::min(here.least_polar,
                                  d + (slope_x * (x - inside.x) + slope_y * (y - inside.y)) / 2.0 - 4.0 * here.error);
    }
  }
  here.depth_error = quadric.middle_error + 1.0 + here.unit * (1.0 + std::sqrt(here.error));
  return here;
}

/// Whether D is certainly concave, even if each coefficient is off by one unit.
bool is_concave(const FixedQuadratic& f) {
  const double xx = static_cast<double>(f.xx) + 1.0;
  const double yy = static_cast<double>(f.yy) + 1.0;
  const double xy = std::abs(static_cast<double>(f.xy)) + 1.0;
  return xx < 0.0 && yy < 0.0 && 4.0 * xx * yy > 1.000001 * xy * xy;
}

/// The growth of a paraboloid. The floors of its middle and of the depth shift z by at most 2 steps, and F = |z - M| -
/// k D is convex.
double growth_of_paraboloid(const ScreenQuadric& quadric, const Around& here) {
  const double k =
      std::ldexp(static_cast<double>(quadric.factor.scaled()), -static_cast<int>(quadric.factor.fraction()));
  const double slack = k * here.d - here.from_middle;
  return slack > 0.0 ? (2.0 + 2.0 * k * here.error) / slack : unlimited;
}

double growth_between(const ScreenQuadric& quadric, const Around& here, const View& view, const PixelRect& pixels) {
  const double half_depth = here.unit * std::sqrt(std::max(0.0, here.d));
  if (!(here.from_middle < half_depth)) return unlimited;
  if (is_concave(quadric.discriminant)) {
    const RootRanges ranges = ranges_over(quadric, view.sampling.fraction_bits, pixels);
    const double most = here.unit * (static_cast<double>(ranges.max_root) + 1.0) + here.depth_error;
    const double beyond =
        2.0 * here.depth_error * most + here.depth_error * here.depth_error + here.error * here.unit * here.unit;
    return beyond / (half_depth * half_depth - here.from_middle * here.from_middle);
  }
  if (here.least_polar <= 0.0) return unlimited;
  return (here.depth_error + std::sqrt(here.error) * here.unit) / (half_depth - here.from_middle);
}

/// The growth of a region beyond one of two depths. Every ray must have these depths.
double growth_beyond(const ScreenQuadric& quadric, QuadricRole role, const glm::dvec3& inside, const Around& here,
                     const PixelRect& pixels) {
  if (range_over(quadric.discriminant, pixels).low <= 0 || !(here.d >= 0.0)) return unlimited;
  const double half_depth = here.unit * std::sqrt(here.d + 2.0 * here.error) + quadric.middle_error;
  const double slack =
      role == QuadricRole::until ? here.middle - half_depth - inside.z : inside.z - here.middle - half_depth;
  return slack > 0.0 ? here.depth_error / slack : unlimited;
}

bool is_in(const glm::dvec3& place, const PixelRect& pixels) {
  return place.x >= pixels.x0 && place.x <= pixels.x1 && place.y >= pixels.y0 && place.y <= pixels.y1;
}

/// Whether the discriminant is negative at all pixels of a column or row.
bool is_outside(const ScreenQuadric& quadric, const PixelRect& line) {
  return range_over(quadric.discriminant, line).high < 0;
}

/// Drops columns and rows at the sides where the discriminant is negative.
void narrow_pixels(PixelRect& pixels, const ScreenQuadric& quadric) {
  if (!pixels.empty() && is_outside(quadric, pixels)) pixels = {};
  while (!pixels.empty() && is_outside(quadric, {pixels.x0, pixels.y0, pixels.x0, pixels.y1})) ++pixels.x0;
  while (!pixels.empty() && is_outside(quadric, {pixels.x1, pixels.y0, pixels.x1, pixels.y1})) --pixels.x1;
  while (!pixels.empty() && is_outside(quadric, {pixels.x0, pixels.y0, pixels.x1, pixels.y0})) ++pixels.y0;
  while (!pixels.empty() && is_outside(quadric, {pixels.x0, pixels.y1, pixels.x1, pixels.y1})) --pixels.y1;
}

}  // namespace

/// Let m be the error of M, d that of D, and U the unit. Then near >= M - m - 1 - U sqrt(D + d) and far <= M + m + U
/// (sqrt(D + d) + 1), so that with e = m + 1 + U (1 + sqrt(d)) every point of a rounded `between` satisfies
///
///     |z - M| <= U sqrt(max(D, 0)) + e   and   D >= -d.
///
/// The unrounded solid is B, |z - M| <= U sqrt(D), cut by planes. The solid scaled by 1 + g about a point c of B
/// contains p if the scaled point c + (p - c) / (1 + g) is in B and within each of the planes.
///
/// - Where D is concave, F = (z - M)^2 - U^2 D is convex, B is F <= 0, and F(p) <= 2 e U sqrt(D) + e^2 + U^2 d. By
///   convexity, F at the scaled point is at most (F(p) + g F(c)) / (1 + g), which is not positive if g >= F(p) / -F(c).
/// - The outline of a cylinder or cone, seen from outside, is two lines: D = k l with linear k and l, here scaled so
///   that they are equal at c. Where k + l > 0, D >= -d makes both >= -s, s = sqrt(d), and D <= (k + s)(l + s). At the
///   scaled point they are at least (k(p) + s + n) / (1 + g) and (l(p) + s + n) / (1 + g), n = g sqrt(D(c)) - s; the
///   geometric mean is superadditive, so U sqrt(D) is at least (U sqrt((k(p) + s)(l(p) + s)) + U n) / (1 + g) there,
///   and |z - M| at most (U sqrt((k(p) + s)(l(p) + s)) + e + g |z(c) - M(c)|) / (1 + g). So g = (e + U s) / (U
///   sqrt(D(c)) - |z(c) - M(c)|) suffices. Up to a positive factor, k + l is D's polar form D(c) + grad D(c) . (p -
///   c) / 2.
/// - From inside, z < near and z >= far are also convex, and move by at most e.
double required_growth(const ScreenQuadric& quadric, facet::QuadricSide side, const glm::dvec3& inside,
                       const View& view, const PixelRect& pixels) {
  const bool has_depths = quadric.kind == ScreenQuadricKind::roots || quadric.kind == ScreenQuadricKind::paraboloid;
  if (!has_depths || pixels.empty() || !is_in(inside, quadric.pixels)) return unlimited;
  const Around here = around(quadric, inside, view, pixels);
  if (quadric.kind == ScreenQuadricKind::paraboloid) return growth_of_paraboloid(quadric, here);
  const QuadricRole role = role_of(quadric, side);
  return role == QuadricRole::between ? growth_between(quadric, here, view, pixels)
                                      : growth_beyond(quadric, role, inside, here, pixels);
}

void narrow_to_quadric(Extent& extent, const ScreenQuadric& quadric, facet::QuadricSide side, const View& view) {
  if (quadric.kind == ScreenQuadricKind::unfit || extent.empty()) return;
  const QuadricRole role = role_of(quadric, side);
  if (role != QuadricRole::until) narrow_pixels(extent.pixels, quadric);
  if (role == QuadricRole::edge || extent.pixels.empty()) return;
  const RootRanges ranges = ranges_over(quadric, view.sampling.fraction_bits, extent.pixels);
  if (ranges.discriminant.low < 0 && role == QuadricRole::until) return;
  if (role == QuadricRole::between) extent.z_low = std::max(extent.z_low, ranges.near.low);
  if (role == QuadricRole::between) extent.z_high = std::min(extent.z_high, ranges.far.high);
  if (role == QuadricRole::until) extent.z_high = std::min(extent.z_high, ranges.near.high);
  if (role == QuadricRole::from) extent.z_low = std::max(extent.z_low, ranges.far.low);
}

}  // namespace csgsim::view
