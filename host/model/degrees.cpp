#include "host/model/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/model/two_doubles.h"

namespace csgsim::model {

namespace {

/// 1 - x^2 / (s+1)(s+2) (1 - x^2 / (s+3)(s+4) (1 - ...)). For s = 0 this is the cosine of x, and for s = 1 the sine
/// without its factor x. For x up to pi / 4 the error is at most 2^-80, including the truncated terms and the rounding
/// of the terms that are single doubles.
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

/// The sine of a sum whose second part is below 2^-52, so that its square is negligible.
double sine(const TwoDoubles& x) {
  return (TwoDoubles{x.high, 0.0} * alternating_series(x.high, 1) + TwoDoubles{x.low * cosine(x.high), 0.0}).high;
}
double cosine(const TwoDoubles& x) {
  return (alternating_series(x.high, 0) + TwoDoubles{-x.low * sine(x.high), 0.0}).high;
}

/// Sine of an angle in [0, 90]. The angle in radians is rounded once, as in OpenSCAD, and the sine is rounded once.
double sin_first_quadrant(double angle) {
  constexpr double radians = std::numbers::pi / 180.0;
  if (angle == 30.0) return 0.5;
  if (angle == 45.0) return std::numbers::sqrt2 / 2.0;
  return angle < 45.0 ? sine(angle * radians) : cosine((90.0 - angle) * radians);
}

TwoDoubles to_radians(int hundredths) {
  constexpr TwoDoubles pi{std::numbers::pi, 1.2246467991473532e-16};
  return TwoDoubles{static_cast<double>(hundredths), 0.0} * pi / 18000.0;
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

double sin_hundredths(int hundredths) {
  constexpr int half_turn = 18000;
  const int turn = (hundredths % (2 * half_turn) + 2 * half_turn) % (2 * half_turn);
  const int rest = turn % half_turn;
  const int quadrant = std::min(rest, half_turn - rest);
  const double sine_of_rest =
      quadrant <= half_turn / 4 ? sine(to_radians(quadrant)) : cosine(to_radians(half_turn / 2 - quadrant));
  return turn >= half_turn ? -sine_of_rest : sine_of_rest;
}

double cos_hundredths(int hundredths) { return sin_hundredths(hundredths % 36000 + 9000); }

}  // namespace csgsim::model
