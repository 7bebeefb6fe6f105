#include "sim/judges/quadric_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgsim::judges {

namespace {

/// Above this condition number, no digits of a double are significant.
constexpr double max_condition = 0x1p45;

/// Number of bits by which a discriminant's rounding exceeds that of a linear function.
constexpr int discriminant_bits = 9;

std::int64_t floor_step(double value) {
  constexpr double limit = 0x1p60;
  return static_cast<std::int64_t>(std::clamp(std::floor(value), -limit, limit));
}

double term_magnitudes(const FilterQuadratic& linear, Place place) {
  return std::abs(linear.c) + std::abs(linear.x * place.x) + std::abs(linear.y * place.y);
}

Maybe most(Maybe a, Maybe b) { return a == b ? a : Maybe::unknown; }

Steps hull(const Steps& a, const Steps& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

/// Movement of the section of a cylinder or cone in an orthographic view, plus the change of its radius, from one depth
/// to another, in pixels; infinite if the section is not an ellipse.
double section_drift(const SightQuadric& quadric, double from, double to) {
  const FilterQuadratic& q = quadric.value;
  const FilterQuadratic& l = quadric.slope;
  const double determinant = 4.0 * q.xx * q.yy - q.xy * q.xy;
  // If it is nearly a parabola or a pair of lines, rounding determines the sign, and it is much longer than the
  // picture.
  if (!(determinant > 0x1p-46 * std::abs(4.0 * q.xx * q.yy))) return infinity;
  struct Section {
    double x, y, value;
  };
  const auto section = [&](double depth) {
    const double gx = q.x + 2.0 * depth * l.x;
    const double gy = q.y + 2.0 * depth * l.y;
    const double x = (q.xy * gy - 2.0 * q.yy * gx) / determinant;
    const double y = (q.xy * gx - 2.0 * q.xx * gy) / determinant;
    return Section{x, y, (quadric.a * depth + 2.0 * l.c) * depth + q.c + (gx * x + gy * y) / 2.0};
  };
  const Section first = section(from);
  const Section middle = section((from + to) / 2.0);
  const Section last = section(to);
  const double least = std::min(std::abs(q.xx), std::abs(q.yy));
  const double first_radius = std::sqrt(std::max(0.0, -first.value / least));
  const double last_radius = std::sqrt(std::max(0.0, -last.value / least));
  // Whether the vertex of the parabola through three values, that is the apex of a cone, is between the ends.
  const bool has_apex =
      std::abs(last.value - first.value) < 2.0 * std::abs(first.value + last.value - 2.0 * middle.value);
  const double radii = has_apex ? first_radius + last_radius : std::abs(last_radius - first_radius);
  return (std::hypot(last.x - first.x, last.y - first.y) + radii) / 2.0;
}

}  // namespace

double DepthLine::ulp() const { return std::ldexp(0.5, -static_cast<int>(fraction_bits)); }

double DepthLine::rounding(Place place) { return 1.0 + (std::abs(place.x) + std::abs(place.y)) / 2.0; }

Steps DepthLine::steps(const FilterQuadratic& linear, double condition, double ulps, Place place) const {
  const double sizes = std::abs(z_at_zero) + std::abs(z_per_q) * term_magnitudes(linear, place);
  const double off = ulps * ulp() + double_part * sizes * condition;
  const double z = z_at_zero + z_per_q * (linear.c + linear.x * place.x + linear.y * place.y);
  return {floor_step(z - off), floor_step(z + off)};
}

QuadricBounds::QuadricBounds(const facet::Geometry& geometry, const Sight& sight, const DepthLine& line)
    : table_(geometry.quadrics), sight_(sight), line_(line) {
  const std::vector<PlaceRect> reaches = quadric_reaches(geometry, sight.camera());
  for (std::uint32_t i = 0; i < reaches.size(); ++i) bounds_.push_back(make_bound(i, reaches[i]));
}

/// Sideways movement of the quadric over the depth range, pixels; infinite if no whole ray can be inside.
double QuadricBounds::drift(std::uint32_t index) const {
  const facet::QuadricKind kind = table_.quadrics()[index].kind;
  const SightQuadric& quadric = sight_.quadrics().quadric(index);
  if (quadric.is_edge) return 0.0;
  if (kind == facet::QuadricKind::cone && sight_.is_perspective()) {
    return apex_shift(table_, index, sight_.camera()) * 2.0 * line_.q_half_range;
  }
  if (kind == facet::QuadricKind::ellipsoid || sight_.is_perspective()) return infinity;
  return section_drift(quadric, line_.q_middle - line_.q_half_range, line_.q_middle + line_.q_half_range);
}

/// Maximum unit that the design allows: for a cylinder in an orthographic view whose root has some bits more than the
/// depth, the number of steps that the surface changes within a fraction of a pixel; 0 without a slope.
int QuadricBounds::max_unit(std::uint32_t index, double greatest_square) const {
  if (table_.quadrics()[index].kind != facet::QuadricKind::cylinder || sight_.is_perspective()) return 0;
  const FilterQuadratic& middle = sight_.quadrics().quadric(index).middle;
  const double slope = 2.0 * line_.z_per_q * std::hypot(middle.x, middle.y);
  const double passed = std::log2(slope * line_.edge_on_fraction) + 0x1p-30;
  const double beyond = std::log2(std::max(1.0, greatest_square)) / 2.0 + 1.0 - line_.z_bits - 2.0;
  return static_cast<int>(std::max(0.0, std::floor(std::min(passed, beyond))));
}

QuadricBounds::Bound QuadricBounds::make_bound(std::uint32_t index, const PlaceRect& reach) const {
  const SightQuadric& quadric = sight_.quadrics().quadric(index);
  Bound bound;
  bound.drift = drift(index);
  bound.across = std::max(0.0, reach.x1 - reach.x0) / 4.0;
  bound.down = std::max(0.0, reach.y1 - reach.y0) / 4.0;
  if (bound.drift < line_.edge_on_fraction / 2.0) {
    bound.nature = Nature::edge;
    bound.greatest = std::max(0.0, -minimum(section(index), reach));
    return bound;
  }
  const bool is_clear = std::isfinite(quadric.square.error) && quadric.condition < max_condition;
  if (!is_clear || bound.drift < 2.0 * line_.edge_on_fraction) {
    bound.nature = Nature::doubtful;
    return bound;
  }
  bound.greatest = std::max(1.0, line_.z_per_q * line_.z_per_q * maximum(quadric.square, reach));
  bound.max_unit = max_unit(index, bound.greatest);
  return bound;
}

QuadricOutcome QuadricBounds::outcome(std::uint32_t index, Place place) const {
  const Bound& bound = bounds_[index];
  QuadricOutcome outcome;
  outcome.is_doubtful = bound.nature == Nature::doubtful;
  outcome.is_edge = bound.nature == Nature::edge;
  if (outcome.is_edge) outcome.is_met = edge_contains_ray(index, place);
  if (bound.nature != Nature::roots) return outcome;
  outcome = outcome_in_units(index, place, 0);
  for (int unit = 1; unit <= bound.max_unit; ++unit) {
    const QuadricOutcome other = outcome_in_units(index, place, unit);
    outcome.is_met = most(outcome.is_met, other.is_met);
    outcome.nearer = hull(outcome.nearer, other.nearer);
    outcome.farther = hull(outcome.farther, other.farther);
  }
  return outcome;
}

QuadricOutcome QuadricBounds::outcome_in_units(std::uint32_t index, Place place, int unit) const {
  const SightQuadric& quadric = sight_.quadrics().quadric(index);
  const Bound& bound = bounds_[index];
  const Steps middle = line_.steps(quadric.middle, quadric.condition, 1.0 + bound.across + bound.down, place);
  const double scale = std::ldexp(line_.z_per_q * line_.z_per_q, -2 * unit);
  const double square = scale * quadric.square.at(place);
  const double greatest = std::max(1.0, std::ldexp(bound.greatest, -2 * unit));
  const double rounding =
      std::sqrt(greatest) * std::ldexp(1.0, discriminant_bits - static_cast<int>(line_.fraction_bits)) + 1.0;
  const double terms = scale * quadric.square_terms;
  const double part = DepthLine::double_part * quadric.condition;
  const double doubles = 2.0 * part * std::sqrt(terms * greatest) + part * part * terms + scale * quadric.square.error;
  const double low = std::floor(square - rounding - doubles);
  const double high = std::floor(square + rounding + doubles);
  QuadricOutcome outcome;
  if (low >= 0.0) outcome.is_met = Maybe::yes;
  if (low < 0.0 && high >= 0.0) outcome.is_met = Maybe::unknown;
  constexpr double root_part = 0x1p-50;
  const std::int64_t step = std::int64_t{1} << unit;
  const std::int64_t least = floor_step(std::sqrt(std::max(0.0, low)) * (1.0 - root_part));
  const std::int64_t most = floor_step(std::sqrt(std::max(0.0, high)) * (1.0 + root_part));
  outcome.nearer = {middle.low - most * step, middle.high - least * step};
  outcome.farther = {middle.low + (least + 1) * step, middle.high + (most + 1) * step};
  return outcome;
}

/// The quadric's section in the middle of the depth range, as a quadratic that is negative inside.
FilterQuadratic QuadricBounds::section(std::uint32_t index) const {
  const SightQuadric& quadric = sight_.quadrics().quadric(index);
  const FilterQuadratic& q = quadric.value;
  const FilterQuadratic& l = quadric.slope;
  const double depth = line_.q_middle;
  return {
      (quadric.a * depth + 2.0 * l.c) * depth + q.c, q.x + 2.0 * depth * l.x, q.y + 2.0 * depth * l.y, q.xx, q.xy, q.yy,
      q.error + 2.0 * std::abs(depth) * l.error};
}

Maybe QuadricBounds::edge_contains_ray(std::uint32_t index, Place place) const {
  const Bound& bound = bounds_[index];
  const FilterQuadratic at = section(index);
  const double value = at.at(place);
  const double along_x = at.x + 2.0 * at.xx * place.x + at.xy * place.y;
  const double along_y = at.y + 2.0 * at.yy * place.y + at.xy * place.x;
  // Twice the maximum rounding, because the rectangle differs from the host's.
  const double rounding = 4.0 * bound.greatest / (1.0 + std::hypot(bound.across, bound.down)) * line_.edge_on_fraction;
  const double zone = 2.0 * std::hypot(along_x, along_y) * bound.drift + rounding + at.error;
  if (std::abs(value) <= zone) return Maybe::unknown;
  return value < 0.0 ? Maybe::yes : Maybe::no;
}

}  // namespace csgsim::judges
