#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "host/model/degrees.h"
#include "host/model/hypotenuse.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Numbers of 50 digits, rounded once to a double; Boost's functions share no code with those under test.
using Real = boost::multiprecision::cpp_bin_float_50;

constexpr int cases = 20'000;

double nearest_hypotenuse(double x, double y) {
  return static_cast<double>(Real(sqrt(Real(x) * Real(x) + Real(y) * Real(y))));
}

}  // namespace

TEST_CASE("a hypotenuse is the double nearest to the 50-digit result") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-10.0, 10.0);
  std::uniform_real_distribution<double> exponent(-60.0, 60.0);
  int wrong = 0;
  for (int i = 0; i < cases; ++i) {
    const double x = number(random);
    const double y = i % 2 == 0 ? number(random) : std::ldexp(number(random), static_cast<int>(exponent(random)));
    if (model::hypotenuse(x, y) != nearest_hypotenuse(x, y)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("a hypotenuse of very large and very small numbers is exact") {
  for (const auto& [x, y] :
       {std::pair{1e308, 1e307}, {1e200, 3e200}, {1e-160, -1e-161}, {-2e-300, 1e-300}, {1e300, 1e-300}, {0.0, -4.5}})
    CHECK(model::hypotenuse(x, y) == nearest_hypotenuse(x, y));
  CHECK(model::hypotenuse(0.0, -0.0) == 0.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(model::hypotenuse(1.7e308, 1.7e308) == infinity);
  CHECK(model::hypotenuse(-infinity, std::nan("")) == infinity);
  CHECK(std::isnan(model::hypotenuse(1.0, std::nan(""))));
}

TEST_CASE("the sine of a rounded angle in radians is the nearest double") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(0.0, 90.0);
  int wrong = 0;
  for (int i = 0; i < cases / 4; ++i) {
    const double degrees = angle(random);
    constexpr double radians = std::numbers::pi / 180.0;
    const double near = degrees < 45.0 ? degrees * radians : (90.0 - degrees) * radians;
    const double expected = static_cast<double>(Real(degrees < 45.0 ? sin(Real(near)) : cos(Real(near))));
    if (model::sin_degrees(degrees) != expected) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("sine and cosine of hundredths of a degree are the nearest doubles") {
  int wrong = 0;
  for (int hundredths = -36000; hundredths <= 36000; hundredths += 11) {
    if (hundredths % 9000 == 0) continue;  // tested below
    const Real radians = boost::math::constants::pi<Real>() * hundredths / 18000;
    if (model::sin_hundredths(hundredths) != static_cast<double>(Real(sin(radians)))) ++wrong;
    if (model::cos_hundredths(hundredths) != static_cast<double>(Real(cos(radians)))) ++wrong;
  }
  CHECK(wrong == 0);
  for (const int turn : {-36000, 0, 36000}) {
    CHECK(model::sin_hundredths(turn) == 0.0);
    CHECK(model::sin_hundredths(turn + 3000) == 0.5);
    CHECK(model::sin_hundredths(turn + 9000) == 1.0);
    CHECK(model::sin_hundredths(turn + 18000) == 0.0);
    CHECK(model::cos_hundredths(turn + 6000) == 0.5);
    CHECK(model::cos_hundredths(turn + 27000) == 0.0);
  }
}
