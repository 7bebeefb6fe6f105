#include "host/model/degrees.h"

#include <cmath>
#include <numbers>

namespace csgsim::model {

namespace {

/// Sine of an angle in [0, 90].
double sin_first_quadrant(double angle) {
  constexpr double radians = std::numbers::pi / 180.0;
  if (angle == 30.0) return 0.5;
  if (angle == 45.0) return std::numbers::sqrt2 / 2.0;
  return angle < 45.0 ? std::sin(angle * radians) : std::cos((90.0 - angle) * radians);
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
