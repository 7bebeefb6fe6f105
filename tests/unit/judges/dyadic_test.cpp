#include "sim/judges/dyadic.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim::judges;

namespace {

using Rational = boost::multiprecision::cpp_rational;

/// Any finite double: zeros, integers, subnormals, and all exponents equally often.
double any_double() {
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return *rc::gen::element(0.0, -0.0, 1.0, -1.0, 0.5, std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::min(), std::numeric_limits<double>::denorm_min(),
                               -std::numeric_limits<double>::denorm_min());
    case 1: return *rc::gen::inRange(-50, 50);
    case 2:
      return std::ldexp(static_cast<double>(*rc::gen::inRange(-1'000'000, 1'000'000)), *rc::gen::inRange(-30, 10));
    default: {
      constexpr std::int64_t limit = std::int64_t{1} << 53;
      return std::ldexp(static_cast<double>(*rc::gen::inRange(-limit, limit)), *rc::gen::inRange(-1074, 970));
    }
  }
}

/// The same number in both kinds of arithmetic.
struct Both {
  Dyadic dyadic;
  Rational rational;
};

Both both(double value) { return {Dyadic(value), Rational(value)}; }

Both operator+(const Both& a, const Both& b) { return {a.dyadic + b.dyadic, a.rational + b.rational}; }
Both operator-(const Both& a, const Both& b) { return {a.dyadic - b.dyadic, a.rational - b.rational}; }
Both operator*(const Both& a, const Both& b) { return {a.dyadic * b.dyadic, a.rational * b.rational}; }

/// Value of a random expression of a few sums, differences and products.
Both any_expression() {
  std::vector<Both> values;
  for (int i = 0; i < 3; ++i) values.push_back(both(any_double()));
  const int steps = *rc::gen::inRange(0, 6);
  for (int i = 0; i < steps; ++i) {
    const Both a = *rc::gen::elementOf(values);
    const Both b = *rc::gen::elementOf(values);
    const int operation = *rc::gen::inRange(0, 3);
    values.push_back(operation == 0 ? a + b : operation == 1 ? a - b : a * b);
  }
  return values.back();
}

int sign(const Rational& value) { return value < 0 ? -1 : value > 0 ? 1 : 0; }

Rational size(const Rational& value) { return value < 0 ? Rational(-value) : value; }

bool in_range(const Rational& value) {
  return size(value) < Rational(std::numeric_limits<double>::max()) &&
         size(value) > Rational(std::numeric_limits<double>::min());
}

}  // namespace

TEST_CASE("dyadic expressions have the sign of rational arithmetic") {
  CHECK(rc::check([] {
    const Both value = any_expression();
    RC_ASSERT(value.dyadic.sign() == sign(value.rational));
    RC_ASSERT((-value.dyadic).sign() == -sign(value.rational));
  }));
}

TEST_CASE("the nearest double of a Dyadic has an error of at most 2^-52 of the value") {
  CHECK(rc::check([] {
    const Both value = any_expression();
    if (!in_range(value.rational)) return;
    const Rational off = Rational(value.dyadic.to_double()) - value.rational;
    RC_ASSERT(size(off) <= size(value.rational) * Rational(0x1p-52));
  }));
}

TEST_CASE("the difference of a number and its nearest double has the right sign") {
  CHECK(rc::check([] {
    const Both value = any_expression();
    const double rounded = value.dyadic.to_double();
    if (!std::isfinite(rounded)) return;
    const Both rest = value - both(rounded);
    RC_ASSERT(rest.dyadic.sign() == sign(rest.rational));
  }));
}

TEST_CASE("a double survives conversion to Dyadic and back") {
  CHECK(rc::check([] {
    const double value = any_double();
    RC_ASSERT(Dyadic(value).to_double() == value);
    RC_ASSERT(Dyadic(value).to_real() == Real(value));
  }));
}

TEST_CASE("the sum of a huge and a tiny number is exact") {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Dyadic sum = Dyadic(huge) + Dyadic(tiny);
  CHECK(sum.to_double() == huge);
  CHECK((sum - Dyadic(huge)).to_double() == tiny);
  CHECK((sum - Dyadic(huge) - Dyadic(tiny)).sign() == 0);
}

TEST_CASE("Dyadic numbers beyond the range of doubles keep their sign") {
  const Dyadic large = Dyadic(-1e300) * Dyadic(1e300);
  CHECK(large.sign() == -1);
  CHECK(large.to_double() == -std::numeric_limits<double>::infinity());
  const Dyadic small = Dyadic(1e-300) * Dyadic(1e-300);
  CHECK(small.sign() == 1);
  CHECK(small.to_double() == 0.0);
}

TEST_CASE("a Dyadic keeps all digits of the multiprecision number it is made from") {
  for (const int of : {2, 3, 5, 1'000'003}) {
    const Real root = sqrt(Real(of)) * pow(Real(10), 30);
    CHECK(Dyadic(root).to_real() == root);
    CHECK(Dyadic(Real(-root)).to_real() == -root);
  }
  CHECK(Dyadic(Real(0)).sign() == 0);
}

TEST_CASE("cross and dot products of Dyadic vectors are exact") {
  CHECK(rc::check([] {
    const glm::dvec3 a(any_double(), any_double(), any_double());
    const glm::dvec3 b(any_double(), any_double(), any_double());
    const Vector across = cross(to_exact(a), to_exact(b));
    RC_ASSERT(dot(across, to_exact(a)).sign() == 0);
    RC_ASSERT(dot(across, to_exact(b)).sign() == 0);
    RC_ASSERT(across[2].sign() == sign(Rational(a.x) * Rational(b.y) - Rational(a.y) * Rational(b.x)));
    RC_ASSERT(dot(to_exact(a), to_exact(b)).sign() ==
              sign(Rational(a.x) * Rational(b.x) + Rational(a.y) * Rational(b.y) + Rational(a.z) * Rational(b.z)));
  }));
}
