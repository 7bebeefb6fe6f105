// Error bounds of quadrics as stated by the design.
// Used by the explainer.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/judges/possible.h"
#include "sim/judges/quadric_reach.h"
#include "sim/judges/sight.h"

namespace csgsim::judges {

/// The conversion of depths q (Sight) to depth steps, with the rounding stated by the design.
struct DepthLine {
  /// Rounding error of doubles, relative to the sum of the terms, times the condition of the coefficients.
  static constexpr double double_part = 0x1p-49;

  double z_at_zero = 0;  ///< depth step of q = 0
  double z_per_q = 1;
  double q_middle = 0;  ///< q in the middle of the depth range
  double q_half_range = 0;
  unsigned z_bits = 0;
  unsigned fraction_bits = 0;
  double edge_on_fraction = 0;  ///< fraction of a pixel

  /// Half a unit in the last place of a surface's coefficient, in depth steps.
  [[nodiscard]] double ulp() const;

  /// Maximum error at the place of a linear function whose coefficients are rounded relative to the middle of the
  /// picture, in units of ulp().
  static double rounding(Place place);

  /// Range of depth steps of a linear function q of the place, rounded by up to `ulps` of ulp(); `condition` as in
  /// SightPlane.
  [[nodiscard]] Steps steps(const FilterQuadratic& linear, double condition, double ulps, Place place) const;

  /// The background as a depth step.
  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << z_bits) - 1; }
};

/// The results that a machine may compute for a quadric at a place.
struct QuadricOutcome {
  bool is_doubtful = false;  ///< any result is allowed
  bool is_edge = false;      ///< whole rays are inside or outside
  Maybe is_met = Maybe::no;  ///< whether the ray meets it; for an edge, whether the ray is inside
  Steps nearer;              ///< range of the nearer depth, if the ray meets it
  Steps farther;
};

/// The bounds that the design states for quadrics (host/view/screen_quadric.h), with f fraction bits. The rectangle of
/// pixels that the solids of a quadric can touch extends w columns and h rows from its middle to its sides:
///
/// - The middle is M = floor(P + e), |e| <= (1 + w + h) 2^-(f+1) steps.
/// - The discriminant is floor(D + e) in units of 4^unit steps squared, |e| <= 2^(9-f) sqrt(D_max) + 1, where D_max is
/// the maximum of D there, and at least 1.
/// - `unit` is 0, except for a cylinder in an orthographic view whose root has more than z_bits + 2 bits: then it is at
/// most the excess, and no more steps than its middle changes in `edge_on_fraction` of a pixel.
/// - The rounding of doubles is added: 2^-49 of the magnitudes of the terms times SightQuadric::condition; in D, twice
/// that fraction of their geometric mean with D_max, as D is computed from the rays' distances from the quadric's
/// middle.
/// - A cylinder (in an orthographic view) or cone that moves less than `edge_on_fraction` of a pixel sideways over the
/// depth range is an edge: its section in the middle of the range, with an error of at most that much again. If the
/// movement is within a factor of 2 of that limit, it may be either.
class QuadricBounds {
 public:
  QuadricBounds(const facet::Geometry& geometry, const Sight& sight, const DepthLine& line);

  [[nodiscard]] QuadricOutcome outcome(std::uint32_t quadric, Place place) const;

 private:
  enum class Nature : std::uint8_t { roots, edge, doubtful };

  struct Bound {
    Nature nature = Nature::roots;
    double greatest = 0;  ///< D_max, depth steps squared; for an edge, how far its section is below 0
    int max_unit = 0;
    double drift = 0;   ///< movement of its section, pixels
    double across = 0;  ///< half the width of the rectangle, pixels
    double down = 0;
  };

  [[nodiscard]] Bound make_bound(std::uint32_t quadric, const PlaceRect& reach) const;
  [[nodiscard]] double drift(std::uint32_t quadric) const;
  [[nodiscard]] int max_unit(std::uint32_t quadric, double greatest_square) const;
  [[nodiscard]] FilterQuadratic section(std::uint32_t quadric) const;
  /// The results that a machine may compute if depths are in units of 2^unit steps.
  [[nodiscard]] QuadricOutcome outcome_in_units(std::uint32_t quadric, Place place, int unit) const;
  [[nodiscard]] Maybe edge_contains_ray(std::uint32_t quadric, Place place) const;

  const facet::QuadricTable& table_;
  const Sight& sight_;
  DepthLine line_;
  std::vector<Bound> bounds_;
};

}  // namespace csgsim::judges
