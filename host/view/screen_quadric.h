#pragma once

#include <cstdint>

#include "host/facet/quadric_table.h"
#include "host/view/fixed_point.h"

namespace csgsim::view {

/// A*x^2 + B*x*y + C*y^2 + linear, with as many fraction bits as its owner says.
struct FixedQuadratic {
  std::int64_t xx = 0;
  std::int64_t xy = 0;
  std::int64_t yy = 0;
  FixedLinear linear;
};

/// Its value at a pixel.
std::int64_t value_at(const FixedQuadratic& quadratic, std::int32_t x, std::int32_t y);

/// Bounds of a quadratic function over a rectangle of pixels, which is not empty: never narrower than its values there.
/// They are its least and greatest values there, except that a top or bottom between pixels counts too, and one between
/// pixels of a side where f.xy is not 0.
Range range_over(const FixedQuadratic& quadratic, const PixelRect& rect);

enum class ScreenQuadricKind : std::uint8_t {
  roots,       ///< two depths on every ray, where the discriminant is not negative
  paraboloid,  ///< a fast sphere: two depths on every ray, without a root (fast_sphere.h)
  edge,        ///< seen along its axis, or from its apex: whole rays are in it or are not
  unfit,       ///< none of both within the machine's numbers: its solids have to be faceted
};

/// 0, a power of two, or a sum or difference of two powers of two: what a field is multiplied by in one or two steps.
struct TwoPowers {
  int first = 0;   ///< exponent of the greater one
  int second = 0;  ///< exponent of the other
  int signs = 0;   ///< 1: the sum; -1: the difference; 0: the first alone
  bool is_zero = true;

  /// Bits after the point.
  [[nodiscard]] unsigned fraction() const;
  /// The number with those bits: an integer.
  [[nodiscard]] std::int64_t scaled() const;
};

/// A canonical quadric in the picture: the same integers for every solid that it bounds.
///
/// Roots: on a ray D = (discriminant >> discriminant_shift), floor. Where D < 0 the ray does not meet the quadric;
/// else, with q = floor(sqrt(D)) and M = middle >> fraction_bits, floor, its depths are
///
///     near = M - (q << unit),    far = M + ((q + 1) << unit)    (depth steps)
///
/// Paraboloid: middle is a constant, an integer c. Where the discriminant is not negative, with its value v and the
/// factor k,
///
///     near = floor(c - k v),    far = floor(c + k v) + 1    (depth steps)
///
/// Edge: the ray is in the quadric where the discriminant is not negative; D has no unit then.
///
/// With unit > 0, D is the square of a depth in units of 2^unit steps.
struct ScreenQuadric {
  ScreenQuadricKind kind = ScreenQuadricKind::roots;
  FixedLinear middle;           ///< with Sampling::fraction_bits
  FixedQuadratic discriminant;  ///< below 2^61 everywhere in the picture
  unsigned discriminant_shift = 0;
  unsigned unit = 0;        ///< depth is right to 2^unit steps; more than 0 only of cylinders in orthographic
                            ///< views that are so steep that this is less than Sampling::edge_on_fraction sideways
  bool eye_inside = false;  ///< the coefficient of depth squared is negative: between its depths a ray is outside
  double middle_error = 0;  ///< bounds of what rounding the scene's quadric does before the floor, over
  double discriminant_error = 0;  ///< `pixels`: of the middle, and of D in its own units. Its doubles count as exact
  PixelRect pixels;               ///< that solids which it bounds can touch
  TwoPowers factor;               ///< of a paraboloid
  bool eye_on_axis_nappe = true;  ///< eye_inside of a cone: the eye is in the nappe that the axis points into
};

/// What a quadric is to a solid that it bounds.
enum class QuadricRole : std::uint8_t {
  between,  ///< in is near <= z < far, where D >= 0; else nothing
  until,    ///< in is z < near: of a ray that begins inside; where D < 0, everything
  from,     ///< in is z >= far: the other nappe, seen through the eye's own; where D < 0, nothing
  edge,     ///< in is where the discriminant is not negative
};

/// What a quadric that is not unfit is to a solid on that side of it.
QuadricRole role_of(const ScreenQuadric& quadric, facet::QuadricSide side);

/// Bounds of the integers of a quadric of two roots, over a rectangle of pixels, which is not empty. Those of the root
/// and of the depths are over the pixels where D is not negative: 0 and empty ranges where there are none.
struct RootRanges {
  Range discriminant;          ///< of D
  std::int64_t most_root = 0;  ///< of q
  Range near{0, -1};
  Range far{0, -1};
};

RootRanges ranges_over(const ScreenQuadric& quadric, unsigned fraction_bits, const PixelRect& rect);

/// floor(sqrt(value)); `value` is not negative.
std::int64_t floor_root(std::int64_t value);

}  // namespace csgsim::view
