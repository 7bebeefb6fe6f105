#include "host/csg/separation.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;

namespace {

using Points = std::vector<glm::dvec3>;

double unit() { return *rc::gen::inRange(-1'000'000, 1'000'001) / 1'000'000.0; }

glm::dvec3 point() { return {unit(), unit(), unit()}; }

Points cloud() {
  Points points(static_cast<std::size_t>(*rc::gen::inRange(1, 30)));
  for (glm::dvec3& one : points) one = point();
  return points;
}

}  // namespace

TEST_CASE("the separation test separates hulls on two sides of a plane for any gap") {
  CHECK(rc::check([] {
    const glm::dvec3 raw = point();
    RC_PRE(glm::length(raw) > 0.1);
    const glm::dvec3 normal = glm::normalize(raw);
    const double gap = std::pow(10.0, -*rc::gen::inRange(1, 6));
    const glm::dvec3 units{1.0, 1e6, 1e-3};
    Points left = cloud();
    Points right = cloud();
    for (glm::dvec3& one : left) one = (one - normal * (glm::dot(one, normal) + gap + std::abs(unit()))) * units;
    for (glm::dvec3& one : right) one = (one - normal * (glm::dot(one, normal) - gap - std::abs(unit()))) * units;
    // Gilbert's algorithm may give up on hulls that nearly touch, but must handle a gap of a hundredth.
    if (gap >= 0.01) RC_ASSERT(csg::separated(left, right));
    RC_ASSERT(!csg::separated(left, left));
  }));
}

TEST_CASE("hulls that share a point are never separated") {
  CHECK(rc::check([] {
    Points left = cloud();
    Points right = cloud();
    // A convex combination of each cloud; one is moved onto the other.
    const auto inner = [](const Points& points) {
      glm::dvec3 sum(0);
      double weights = 0;
      for (const glm::dvec3& one : points) {
        const double weight = std::abs(unit()) + 1e-3;
        sum += weight * one;
        weights += weight;
      }
      return sum / weights;
    };
    const glm::dvec3 shared = inner(left);
    const glm::dvec3 shift = shared - inner(right);
    for (glm::dvec3& one : right) one += shift;
    // Rounding can displace coordinates near 0, so the shared point is added to both clouds.
    left.push_back(shared);
    right.push_back(shared);
    RC_ASSERT(!csg::separated(left, right));
    RC_ASSERT(!csg::separated(right, left));
  }));
}

TEST_CASE("no hull is separated from an empty set of points") { CHECK_FALSE(csg::separated({}, Points{{0, 0, 0}})); }
