#include "sim/judges/surd.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;
using namespace judges;

namespace {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200>>;

Surd surd(double whole, int root, double square, double over) {
  return {Dyadic(whole), root, Dyadic(square), Dyadic(over)};
}

/// The numbers of a Surd, which cannot be read back from Dyadic.
struct Numbers {
  double whole, square, over;
  int root;

  [[nodiscard]] Surd exact() const { return surd(whole, root, square, over); }
  [[nodiscard]] Long value() const { return (Long(whole) + root * sqrt(Long(square))) / Long(over); }
};

/// Small integers, so that equal numbers are common, multiplied by powers of two.
Numbers any_numbers() {
  const double scale = *rc::gen::element(1.0, 0x1p-40, 0x1p70);
  const int over = *rc::gen::inRange(1, 7);
  return {scale * *rc::gen::inRange(-9, 10), scale * scale * *rc::gen::inRange(0, 30),
          over * *rc::gen::element(-1.0, 1.0), *rc::gen::inRange(-1, 2)};
}

/// Changes a number by its last bit.
double nudged(double value) { return value * (1.0 + *rc::gen::element(0.0, 0x1p-52, -0x1p-52)); }

}  // namespace

TEST_CASE("equal numbers with different square-root terms compare as equal") {
  CHECK(compare(surd(0, 1, 8, 1), surd(0, 1, 2, 0.5)) == 0);
  CHECK(compare(surd(3, -1, 9, 1), surd(0, 0, 0, 5)) == 0);
  CHECK(compare(surd(1, 1, 2, 1), surd(-1, -1, 2, -1)) == 0);
  CHECK(compare(surd(4, 1, 12, 2), surd(2, 1, 3, 1)) == 0);
  CHECK(compare(surd(7, 1, 0, 1), surd(7, -1, 0, 1)) == 0);
}

TEST_CASE("square-root numbers that differ beyond double precision compare exactly") {
  // 99^2 = 2 70^2 + 1, and so on: the best approximations of the root of 2 from above and below.
  CHECK(compare(surd(0, 1, 2, 1), surd(99, 0, 0, 70)) < 0);
  CHECK(compare(surd(0, 1, 2, 1), surd(6625109, 0, 0, 4684660)) != 0);
  CHECK(compare(surd(0, 1, 1 + 0x1p-52, 1), surd(1, 0, 0, 1)) > 0);
  CHECK(compare(surd(0, 1, 1 + 0x1p-52, 1), surd(1 + 0x1p-52, 0, 0, 1)) < 0);
  CHECK(compare(surd(1, -1, 0x1p-200, 1), surd(1, 0, 0, 1)) < 0);
}

TEST_CASE("square-root comparisons match arithmetic of 200 digits") {
  int equal = 0;
  CHECK(rc::check([&] {
    Numbers a = any_numbers();
    Numbers b = any_numbers();
    if (*rc::gen::inRange(0, 3) == 0) {
      // The same number in another form: both terms multiplied by a number and the radicand by its square.
      const double factor = *rc::gen::element(-2.0, 2.0, 3.0, 4.0, 0.5);
      b = {a.whole * factor, a.square * factor * factor, a.over * factor, factor > 0 ? a.root : -a.root};
      if (*rc::gen::arbitrary<bool>()) b.whole = nudged(b.whole);
      if (*rc::gen::arbitrary<bool>()) b.square = nudged(b.square);
    }
    const Long difference = a.value() - b.value();
    const Long size = abs(a.value()) + abs(b.value());
    // Numbers of a few hundred bits with a smaller difference are equal.
    const bool same = abs(difference) <= size * Long("1e-190");
    equal += same ? 1 : 0;
    RC_ASSERT(compare(a.exact(), b.exact()) == (same ? 0 : difference.sign()));
    RC_ASSERT(compare(b.exact(), a.exact()) == (same ? 0 : -difference.sign()));
  }));
  CHECK((!testing::draws_usual_cases() || equal > 3));
}
