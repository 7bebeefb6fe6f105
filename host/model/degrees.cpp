#include "host/model/degrees.h"

#include <cmath>
#include <numbers>

#include "host/model/two_doubles.h"

namespace csgsim::model {

namespace {

/// 1 - x^2 / (s+1)(s+2) (1 - x^2 / (s+3)(s+4) (1 - ...)): the cosine of x from s = 0 on, the sine without its factor x
/// from s = 1 on. Of x up to pi / 4 it is right to 2^-80: what is left out, and what rounding takes from the terms that
/// are one double, is less.
TwoDoubles alternating_series(double x, int start) {
  constexpr int of_one_double = 5;
  constexpr int of_two_doubles = 6;
  const TwoDoubles square = exact_product(x, x);
  const auto denominator = [start](int term) {
    return static_cast<double>((start + 2 * term) * (start + 2 * term - 1));
  };
  double rest = 1.0;
  int term = of_two_doubles + of_one_double;
  for (; term > of_two_doubles; --term) rest = 1.0 - square.high * rest / denominator(term);
  TwoDoubles sum{rest, 0.0};
  for (; term > 0; --term) sum = TwoDoubles{1.0, 0.0} + -(square * sum / denominator(term));
  return sum;
}

double sine(double x) { return (TwoDoubles{x, 0.0} * alternating_series(x, 1)).high; }
double cosine(double x) { return alternating_series(x, 0).high; }

/// Sine of an angle in [0, 90]. The angle in radians is rounded once, as OpenSCAD's, and its sine once.
double sin_first_quadrant(double angle) {
  constexpr double radians = std::numbers::pi / 180.0;
  if (angle == 30.0) return 0.5;
  if (angle == 45.0) return std::numbers::sqrt2 / 2.0;
  return angle < 45.0 ? sine(angle * radians) : cosine((90.0 - angle) * radians);
}

}  // namespace

double sin_degrees(double angle) {
  double turn = std::fmod(angle, 360.0);
  if (turn < 0.0) turn += 360.0;
  const bool negative = turn >= 180.0;
  if (negative) turn -= 180.0;
  if (turn > 90.0) turn = 180.0 - turn;
  const double sine = sin_first_quadrant(turn);
  return negative ? -sine : sine;
}

double cos_degrees(double angle) { return sin_degrees(std::fmod(angle, 360.0) + 90.0); }

}  // namespace csgsim::model
