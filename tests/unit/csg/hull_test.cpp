#include "host/csg/hull.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;

namespace {

using Points = std::vector<glm::dvec3>;

/// Coordinates on a coarse grid, so that many points are equally far.
glm::dvec3 coarse(int steps) {
  const double x = *rc::gen::inRange(-steps, steps + 1);
  const double y = *rc::gen::inRange(-steps, steps + 1);
  return glm::dvec3(x, y, *rc::gen::inRange(-steps, steps + 1)) / 7.0;
}

std::size_t first_farthest(const Points& points, const glm::dvec3& direction) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (glm::dot(points[i], direction) > glm::dot(points[best], direction)) best = i;
  return best;
}

}  // namespace

TEST_CASE("support() returns the first of the farthest points on every call") {
  CHECK(rc::check([] {
    const int steps = *rc::gen::element(2, 30, 1'000'000);
    Points points(static_cast<std::size_t>(*rc::gen::inRange(1, 300)));
    for (glm::dvec3& one : points) one = coarse(steps) * glm::dvec3(1, 1e6, 1e-3);
    csg::Hull hull(points);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 direction = coarse(3) / glm::dvec3(1, 1e6, 1e-3);
      const auto found = static_cast<std::size_t>(&hull.support(direction) - points.data());
      RC_ASSERT(found == first_farthest(points, direction));
    }
  }));
}

TEST_CASE("a hull returns the minimum and maximum coordinates of its points") {
  const Points points{{1, 5, -2}, {-3, 4, 7}, {2, 9, 0}};
  const csg::Hull hull(points);
  CHECK(hull.low() == glm::dvec3(-3, 4, -2));
  CHECK(hull.high() == glm::dvec3(2, 9, 7));
}
