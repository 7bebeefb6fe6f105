#include "host/solids/exact_sign.h"

#include <boost/multiprecision/cpp_int.hpp>

#include "tests/support/test.h"

using namespace csgsim;
using namespace solids;

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Rows = std::array<Difference, 3>;

int expected(const Rows& rows) {
  std::array<std::array<Rational, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[i][static_cast<std::size_t>(k)] = Rational(rows[i].to[k]) - Rational(rows[i].from[k]);
  }
  const Rational value = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return value.sign();
}

/// Coordinates of few bits, of many, and of very different magnitudes.
class Coordinates {
 public:
  double operator()() {
    switch (random_() % 4) {
      case 0: return static_cast<double>(random_() % 5) - 2.0;
      case 1: return uniform_(random_);
      case 2: return std::ldexp(uniform_(random_), static_cast<int>(random_() % 200) - 100);
      default: return 1e6 + 1e-9 * uniform_(random_);
    }
  }

  glm::dvec3 point() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937_64 random_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

}  // namespace

TEST_CASE("the sign of a determinant of differences equals rational arithmetic's") {
  Coordinates coordinates;
  int zeros = 0;
  for (int round = 0; round < 20'000; ++round) {
    Rows rows{};
    for (Difference& row : rows) row = {coordinates.point(), coordinates.point()};
    // The third row is the rounded combination of the first two: exactly dependent, or off by the last bits.
    if (round % 2 == 0) rows[2] = {rows[0].to - rows[0].from + (rows[1].to - rows[1].from), glm::dvec3(0)};
    if (round % 8 == 0) rows[1] = {rows[0].from, rows[0].to};
    const int sign = expected(rows);
    zeros += sign == 0 ? 1 : 0;
    CAPTURE(round);
    REQUIRE(sign_of_determinant(rows) == sign);
  }
  CHECK(zeros > 2000);
  CHECK(zeros < 10'000);
}

TEST_CASE("sign_of_determinant() has no result for 0 if doubles may under- or overflow") {
  const glm::dvec3 origin(0);
  for (const double size : {1e-80, 1e100}) {
    const glm::dvec3 along(size, 0, 0);
    CHECK_FALSE(sign_of_determinant({{{along, origin}, {along, origin}, {{0, 1, 0}, origin}}}).has_value());
  }
  CHECK(sign_of_determinant({{{{1e-80, 0, 0}, origin}, {{0, 1, 0}, origin}, {{0, 0, 1}, origin}}}) == 1);
}
