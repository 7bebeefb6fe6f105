// Quadrics in screen space, as integer functions of the pixel.
// Used by host/emit.
#pragma once

#include <cstdint>

#include "host/facet/quadric_table.h"
#include "host/view/fixed_point.h"

namespace csgsim::view {

/// A*x^2 + B*x*y + C*y^2 + linear; the owner defines the number of fraction bits.
struct FixedQuadratic {
  std::int64_t xx = 0;
  std::int64_t xy = 0;
  std::int64_t yy = 0;
  FixedLinear linear;
};

/// The value at a pixel.
std::int64_t value_at(const FixedQuadratic& quadratic, std::int32_t x, std::int32_t y);

/// Bounds of a quadratic function over a non-empty rectangle of pixels. They are the exact minimum and maximum, except
/// that an extremum between pixels also counts, and, if f.xy is not 0, an extremum between two pixels of a side.
Range range_over(const FixedQuadratic& quadratic, const PixelRect& rect);

enum class ScreenQuadricKind : std::uint8_t {
  roots,       ///< two depths on every ray, where the discriminant is not negative
  paraboloid,  ///< a fast sphere: two depths on every ray, without a square root (fast_sphere.h)
  edge,        ///< seen along its axis or from its apex: each ray is entirely inside or outside
  unfit,       ///< cannot be represented in the machine's numbers: its solids must be faceted
};

/// Zero, a power of two, or a sum or difference of two powers of two: a factor by which the hardware multiplies in one
/// or two steps.
struct TwoPowers {
  int first = 0;   ///< exponent of the greater power
  int second = 0;  ///< exponent of the smaller power
  int signs = 0;   ///< 1 for the sum; -1 for the difference; 0 if there is only the first power
  bool is_zero = true;

  /// Number of fraction bits.
  [[nodiscard]] unsigned fraction() const;
  /// The number times 2^fraction(): an integer.
  [[nodiscard]] std::int64_t scaled() const;
};

/// A canonical quadric in the picture: all solids that it bounds share its integers.
///
/// Roots: on a ray, D = floor(discriminant >> discriminant_shift). If D < 0, the ray does not meet the quadric; else,
/// with q = floor(sqrt(D)) and M = floor(middle >> fraction_bits), its depths are
///
///     near = M - (q << unit),    far = M + ((q + 1) << unit)    (depth steps)
///
/// Paraboloid: middle is a constant integer c. Where the discriminant is not negative, with its value v and the factor
/// k, the depths are
///
///     near = floor(c - k v),    far = floor(c + k v) + 1    (depth steps)
///
/// Edge: the ray is inside the quadric where the discriminant is not negative; D has no unit.
///
/// D is the square of a depth in units of 2^unit steps.
struct ScreenQuadric {
  ScreenQuadricKind kind = ScreenQuadricKind::roots;
  FixedLinear middle;           ///< with Sampling::fraction_bits fraction bits
  FixedQuadratic discriminant;  ///< below 2^61 everywhere in the picture
  unsigned discriminant_shift = 0;
  /// Depths are multiples of 2^unit steps; greater than 0 only for cylinders in orthographic views that are so steep
  /// that the error is less than Sampling::edge_on_fraction sideways.
  unsigned unit = 0;
  /// Whether the coefficient of depth squared is negative: a ray is then outside between its two depths.
  bool eye_inside = false;
  double middle_error = 0;  ///< bound over `pixels` of the rounding error of the middle before the floor
  /// Bound over `pixels` of the rounding error of D, in units of D; the doubles of the scene's quadric count as exact.
  double discriminant_error = 0;
  PixelRect pixels;  ///< pixels that its solids can touch
  TwoPowers factor;  ///< factor of a paraboloid
  /// For a cone with eye_inside: whether the eye is in the nappe into which the axis points.
  bool eye_on_axis_nappe = true;
};

/// The relation of a quadric to a solid that it bounds.
enum class QuadricRole : std::uint8_t {
  between,  ///< inside is near <= z < far where D >= 0; no depth is inside elsewhere
  until,    ///< for a ray that begins inside: inside is z < near; every depth is inside where D < 0
  /// Inside is z >= far, which is the other nappe as seen from inside the first; no depth is inside where D < 0.
  from,
  edge,  ///< inside is where the discriminant is not negative
};

/// The role of a quadric, which must not be unfit, for a solid on the given side of it.
QuadricRole role_of(const ScreenQuadric& quadric, facet::QuadricSide side);

/// Bounds of the integers of a quadric with two roots, over a non-empty rectangle of pixels. Those of the root and the
/// depths cover the pixels where D is not negative; if there are none, they are 0 and empty ranges.
struct RootRanges {
  Range discriminant;         ///< range of D
  std::int64_t max_root = 0;  ///< maximum of q
  Range near{0, -1};
  Range far{0, -1};
};

RootRanges ranges_over(const ScreenQuadric& quadric, unsigned fraction_bits, const PixelRect& rect);

/// floor(sqrt(value)); `value` must not be negative.
std::int64_t floor_root(std::int64_t value);

}  // namespace csgsim::view
