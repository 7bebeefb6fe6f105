#include "host/swept/curve.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/swept/support.h"

using namespace csgsim;
using namespace swept;

namespace {

Curve random_curve() {
  Curve curve;
  curve.degree = *rc::gen::inRange<std::uint32_t>(1, 4);
  curve.closed = *rc::gen::arbitrary<bool>();
  const auto count = *rc::gen::inRange<std::size_t>(4, 9);
  for (std::size_t i = 0; i < count; ++i)
    curve.points.emplace_back(*rc::gen::inRange(-50, 51), *rc::gen::inRange(-50, 51), *rc::gen::inRange(-50, 51));
  return curve;
}

}  // namespace

TEST_CASE("segments of a B-spline equal the sum of its basis functions") {
  CHECK(rc::check([] {
    const Curve curve = random_curve();
    const std::vector<Segment> segments = swept::bernstein_segments(curve);
    RC_ASSERT(segments.size() == curve.points.size() - (curve.closed ? 0 : curve.degree));
    for (std::size_t k = 0; k < segments.size(); ++k) {
      for (const double t : {0.0, 0.125, 0.3, 0.5, 0.9375}) {
        const glm::dvec3 expected = swept_test::by_basis(curve, static_cast<double>(k) + t);
        RC_ASSERT(glm::distance(swept::at(segments[k], t), expected) < 1e-12 * 100);
      }
    }
  }));
}

TEST_CASE("a curve's segments join and a closed curve ends where it starts") {
  CHECK(rc::check([] {
    const Curve curve = random_curve();
    const std::vector<Segment> segments = swept::bernstein_segments(curve);
    for (std::size_t k = 1; k < segments.size(); ++k) RC_ASSERT(segments[k].first() == segments[k - 1].last());
    if (curve.closed) {
      RC_ASSERT(segments.back().last() == segments.front().first());
    } else {
      RC_ASSERT(glm::distance(segments.front().first(), curve.points.front()) < 1e-12);
      RC_ASSERT(glm::distance(segments.back().last(), curve.points.back()) < 1e-12);
    }
  }));
}

TEST_CASE("the halves of a curve's segment are the same curve and meet at identical numbers") {
  CHECK(rc::check([] {
    const Segment segment = swept::bernstein_segments(random_curve()).front();
    const auto [first, second] = swept::halves(segment);
    RC_ASSERT(first.first() == segment.first());
    RC_ASSERT(second.last() == segment.last());
    RC_ASSERT(first.last() == second.first());
    for (const double t : {0.0, 0.2, 0.5, 0.75, 1.0}) {
      RC_ASSERT(glm::distance(swept::at(first, t), swept::at(segment, t / 2)) < 1e-12);
      RC_ASSERT(glm::distance(swept::at(second, t), swept::at(segment, (t + 1) / 2)) < 1e-12);
    }
  }));
}

TEST_CASE("the slope of a curve's segment is the difference quotient of close points") {
  const Segment segment{3, {{{0, 0, 0}, {1, 2, 0}, {3, -1, 4}, {2, 2, 2}}}};
  constexpr double step = 1e-6;
  for (const double t : {0.1, 0.5, 0.8}) {
    const glm::dvec3 difference = (swept::at(segment, t + step) - swept::at(segment, t - step)) / (2 * step);
    CHECK(glm::distance(swept::slope(segment, t), difference) < 1e-8);
  }
}

TEST_CASE("a curve with an invalid degree or number of points is rejected") {
  CHECK(swept::validation_error(Curve{4, false, {}}) == "degree 4 is above 3; use 0 (constant), 1, 2 or 3");
  CHECK(swept::validation_error(Curve{3, false, {{}, {}, {}}}) ==
        "an open curve of degree 3 needs at least 4 points, not 3");
  CHECK(swept::validation_error(Curve{1, true, {{}, {}}}) ==
        "a closed curve of degree 1 needs at least 3 points, not 2");
  CHECK(swept::validation_error(Curve{0, false, {{}, {}}}) ==
        "a constant, of degree 0, has one point, not 2; use degree 1");
  CHECK(swept::validation_error(Curve{0, false, {{}}}) == "");
  CHECK(swept::validation_error(Curve{1, false, std::vector<glm::dvec3>(10'001)}) ==
        "a curve of 10001 points has more than 10000; remove points");
  CHECK(swept::validation_error(Curve{3, true, {{}, {}, {}, {}}}) == "");
}