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

  /// Depth steps that a linear function q of the place may have; `condition` as that of SightPlane.
  [[nodiscard]] Steps steps(const FilterQuadratic& linear, double condition, Place place) const;

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

/// What the design states of quadrics (host/view/quadrics.h), dx columns and dy rows from the middle of the picture,
/// with f fraction bits:
///
/// - The middle is M = floor(P + e), |e| <= (1 + dx + dy) 2^-(f+1) steps.
/// - The discriminant is floor(D + e) in units of 4^unit steps squared, |e| <= 2^(9-f) sqrt(D_max) + 1, where D_max is
///   the greatest D at the pixels that its solids can touch.
/// - To both comes what doubles do to the coefficients: 2^-49 of the sum of their terms times
///   SightQuadric::condition.
/// - `unit` is the least that leaves the root at those pixels as many bits as depth has; where the bounds do not tell,
///   it may be one more or less.
/// - A quadric whose section moves by less than `edge_on_fraction` of a pixel from the nearest depth to the farthest
///   is an edge. Where that is closer than a factor of 2 it may be either.
class QuadricBounds {
 public:
  QuadricBounds(const facet::Scene& scene, const Sight& sight, const DepthLine& line);

  [[nodiscard]] QuadricMet met(std::uint32_t quadric, Place place) const;

 private:
  enum class Nature : std::uint8_t { roots, edge, doubtful };

  struct Bound {
    Nature nature = Nature::roots;
    double greatest = 0;  ///< D_max, depth steps squared
    int least_unit = 0;
    int most_unit = 0;
    double drift = 0;  ///< of an edge: pixels that its section moves
  };

  [[nodiscard]] Bound make_bound(std::uint32_t quadric, const PlaceRect& reach) const;
  [[nodiscard]] QuadricMet with_unit(std::uint32_t quadric, Place place, int unit) const;
  [[nodiscard]] Maybe edge_holds(std::uint32_t quadric, Place place) const;

  const Sight& sight_;
  DepthLine line_;
  std::vector<Bound> bounds_;
};

}  // namespace csgsim::judges
