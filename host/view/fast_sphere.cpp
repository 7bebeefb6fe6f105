#include "host/view/fast_sphere.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "hw/isa/depth_scale.h"

namespace csgsim::view {

namespace {

/// Fraction bits of r^2 - d^2, in square pixels.
constexpr unsigned outline_fraction_bits = 8;

/// Maximum difference of the two exponents: with a greater difference, the second power would cost more bits than its
/// accuracy is worth.
constexpr int max_exponent_gap = 4;

/// Maximum width of the sums from which depths are computed; additions of fields are limited to it.
constexpr int max_sum_bits = 32;

/// Maximum width of the expressions of depths.
constexpr int max_expression_bits = 60;

/// The greatest sum or difference of two powers of two that does not exceed `most`.
TwoPowers greatest_within(double most) {
  TwoPowers best;
  if (!(most > 0.0)) return best;
  const int exponent = std::ilogb(most);
  best = {exponent, exponent, 0, false};
  double value = std::ldexp(1.0, exponent);
  const auto take = [&](const TwoPowers& one) {
    const double of_one = std::ldexp(1.0, one.first) + one.signs * std::ldexp(1.0, one.second);
    if (of_one <= value || of_one > most) return;
    best = one;
    value = of_one;
  };
  for (int between = 1; between <= max_exponent_gap; ++between) {
    take({exponent, exponent - between, 1, false});
    take({exponent + 1, exponent + 1 - between, -1, false});
  }
  return best;
}

/// r^2 - d^2 about a centre: each coefficient is rounded once relative to the middle pixel, and then shifted exactly to
/// the picture's first pixel.
FixedQuadratic circle(double column, double row, double radius, const PixelRect& pixels) {
  const std::int64_t x = (std::int64_t{pixels.x0} + pixels.x1) / 2;
  const std::int64_t y = (std::int64_t{pixels.y0} + pixels.y1) / 2;
  const double u = column - static_cast<double>(x);
  const double v = row - static_cast<double>(y);
  const auto rounded = [](double value) {
    return static_cast<std::int64_t>(std::llround(std::ldexp(value, outline_fraction_bits)));
  };
  const std::int64_t one = std::int64_t{1} << outline_fraction_bits;
  const std::int64_t a = rounded(2 * u);
  const std::int64_t b = rounded(2 * v);
  const std::int64_t c = rounded(radius * radius - u * u - v * v);
  return {-one, 0, -one, {a + 2 * one * x, b + 2 * one * y, c - a * x - b * y - one * (x * x + y * y)}};
}

int signed_bits(double value) { return value < 1.0 ? 1 : std::ilogb(value) + 2; }

/// Whether the numbers from which depths are computed fit the machine.
bool fits(const ScreenQuadric& screen, const Sampling& sampling) {
  const int fraction = static_cast<int>(screen.factor.fraction());
  const RootRanges ranges = ranges_over(screen, sampling.fraction_bits, screen.pixels);
  const auto most = static_cast<double>(std::max(std::abs(ranges.near.low), std::abs(ranges.far.high)));
  const double side = std::max(sampling.width, sampling.height);
  const double square = 8.0 * side * side * std::ldexp(static_cast<double>(screen.factor.scaled()), -fraction);
  const int sum = std::max(signed_bits(most) + 1, static_cast<int>(sampling.z_bits) + 2) + fraction;
  return sum <= max_sum_bits &&
         signed_bits(std::abs(most) + square) + fraction + static_cast<int>(outline_fraction_bits) <=
             max_expression_bits;
}

}  // namespace

ScreenQuadric make_fast_sphere(const EyeSpace& space, const View& view, const facet::Quadric& quadric,
                               const glm::dvec3& centre, const PixelRect& pixels) {
  const Sampling& sampling = view.sampling;
  ScreenQuadric screen;
  screen.kind = ScreenQuadricKind::paraboloid;
  screen.pixels = pixels;
  screen.discriminant_shift = outline_fraction_bits;
  if (pixels.empty()) {
    screen.discriminant.linear.c = -1;
    return screen;
  }
  screen.kind = ScreenQuadricKind::unfit;
  const double row_length =
      (glm::length(quadric.to_unit[0]) + glm::length(quadric.to_unit[1]) + glm::length(quadric.to_unit[2])) / 3;
  const double radius = 1.0 / row_length / space.pixel;
  const double most_radius = 8.0 * std::max(sampling.width, sampling.height);
  const glm::dvec3 in_eye = space.to_eye(quadric.origin + centre);
  const glm::dvec3 place = space.to_picture(in_eye);
  const double steps = isa::depth_steps(sampling.z_bits) / (view.depth.far - view.depth.near) / row_length;
  const double middle = std::floor(isa::depth_of(view.depth, sampling.z_bits, in_eye.z));
  const bool is_near_picture = std::abs(place.x) < 4 * most_radius && std::abs(place.y) < 4 * most_radius;
  // Unfit in perspective, and if the sphere is far larger than the picture or far deeper than the depth range.
  if (space.perspective || !is_near_picture || radius > most_radius ||
      std::abs(middle) + steps > std::ldexp(1.0, max_sum_bits))
    return screen;
  screen.discriminant = circle(place.x, place.y, radius, pixels);
  const double across = 1.0 + (pixels.x1 - pixels.x0) / 2.0 + (pixels.y1 - pixels.y0) / 2.0 + 1.0;
  screen.discriminant_error = std::ldexp(across, -static_cast<int>(outline_fraction_bits) - 1);
  screen.middle.c = static_cast<std::int64_t>(middle) << sampling.fraction_bits;
  screen.middle_error = 1.0;
  screen.factor = greatest_within((steps - 1.0) / (radius * radius + screen.discriminant_error));
  screen.kind = ScreenQuadricKind::paraboloid;
  if (!fits(screen, sampling)) screen.kind = ScreenQuadricKind::unfit;
  return screen;
}

double paraboloid_depth(const ScreenQuadric& quadric, const Sampling& sampling, double x, double y, bool is_near) {
  const FixedQuadratic& f = quadric.discriminant;
  const double value = static_cast<double>(f.xx) * x * x + static_cast<double>(f.yy) * y * y +
                       static_cast<double>(f.linear.a) * x + static_cast<double>(f.linear.b) * y +
                       static_cast<double>(f.linear.c);
  const int shift = static_cast<int>(quadric.discriminant_shift + quadric.factor.fraction());
  const double half = std::ldexp(static_cast<double>(quadric.factor.scaled()) * std::max(0.0, value), -shift);
  const double middle = std::ldexp(static_cast<double>(quadric.middle.c), -static_cast<int>(sampling.fraction_bits));
  return is_near ? middle - half : middle + half;
}

}  // namespace csgsim::view
