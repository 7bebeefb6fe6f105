#pragma once

#include <cstdint>
#include <vector>

#include "sim/judges/possible.h"
#include "sim/judges/quadric_reach.h"
#include "sim/judges/sight.h"

namespace csgsim::judges {

/// How depths q (Sight) become depth steps, and what the design states of rounding.
struct DepthLine {
  /// What doubles lose, as a part of the sum of the terms, times the condition of the coefficients.
  static constexpr double double_part = 0x1p-49;

  double z_at_zero = 0;  ///< depth step of q = 0
  double z_per_q = 1;
  double q_middle = 0;  ///< q where half the depth range is passed
  double q_half_range = 0;
  unsigned z_bits = 0;
  unsigned fraction_bits = 0;
  double edge_on_fraction = 0;  ///< of a pixel

  /// Half a unit of a coefficient of a surface, depth steps.
  [[nodiscard]] double ulp() const;

  /// How far rounded coefficients may take a linear function from what it is at the middle of the picture, in ulp().
  static double rounding(Place place);

  /// Depth steps that a linear function q of the place may have when it is rounded by up to `ulps` of ulp();
  /// `condition` as in SightPlane.
  [[nodiscard]] Steps steps(const FilterQuadratic& linear, double condition, double ulps, Place place) const;

  /// "Nothing", as a depth step.
  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << z_bits) - 1; }
};

/// What a machine may make of a quadric at a place.
struct QuadricMet {
  bool doubtful = false;     ///< anything
  bool edge = false;         ///< whole rays are in it or are not
  Maybe is_met = Maybe::no;  ///< whether the ray meets it; of an edge, is in it
  Steps nearer;              ///< where, if it does
  Steps farther;
};

/// What the design states of quadrics (host/view/screen_quadric.h), with f fraction bits, over the rectangle of pixels
/// that the solids of a quadric can touch, w columns and h rows from its middle to its sides:
///
/// - The middle is M = floor(P + e), |e| <= (1 + w + h) 2^-(f+1) steps.
/// - The discriminant is floor(D + e) in units of 4^unit steps squared, |e| <= 2^(9-f) sqrt(D_max) + 1, where D_max is
///   the greatest D there, and at least 1.
/// - `unit` is 0, except for a cylinder in an orthographic view whose root has more bits than depth has and two: then
///   it is at most that excess, and no more steps than its middle passes in `edge_on_fraction` of a pixel.
/// - The rounding of doubles comes on top: 2^-49 of the sizes of the terms times SightQuadric::condition; in D, twice
///   that part of their geometric mean with D_max, as D is worked out from how far rays miss the quadric's middle.
/// - A cylinder (of an orthographic view) or cone that moves less than `edge_on_fraction` of a pixel sideways over the
///   depth range is an edge: its section where half of the range is passed, off by no more than as much again. Where
///   that is closer than a factor of 2, it may be either.
class QuadricBounds {
 public:
  QuadricBounds(const facet::Geometry& geometry, const Sight& sight, const DepthLine& line);

  [[nodiscard]] QuadricMet met(std::uint32_t quadric, Place place) const;

 private:
  enum class Nature : std::uint8_t { roots, edge, doubtful };

  struct Bound {
    Nature nature = Nature::roots;
    double greatest = 0;  ///< D_max, depth steps squared; of an edge, how far its section is below 0
    int most_unit = 0;
    double drift = 0;   ///< pixels that its section moves
    double across = 0;  ///< half the rectangle, pixels
    double down = 0;
  };

  [[nodiscard]] Bound make_bound(std::uint32_t quadric, const PlaceRect& reach) const;
  [[nodiscard]] double drift(std::uint32_t quadric) const;
  [[nodiscard]] int most_unit(std::uint32_t quadric, double greatest_square) const;
  [[nodiscard]] FilterQuadratic section(std::uint32_t quadric) const;
  [[nodiscard]] QuadricMet with_unit(std::uint32_t quadric, Place place, int unit) const;
  [[nodiscard]] Maybe edge_holds(std::uint32_t quadric, Place place) const;

  const facet::QuadricTable& table_;
  const Sight& sight_;
  DepthLine line_;
  std::vector<Bound> bounds_;
};

}  // namespace csgsim::judges
