#include "sim/judges/quadric_reach.h"

#include <rapidcheck.h>

#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using namespace judges;

namespace {

double any(int most) { return *rc::gen::inRange(-most * 100, most * 100) / 100.0; }

}  // namespace

TEST_CASE("the minimum and maximum of a quadratic over a rectangle are tight") {
  CHECK(rc::check([] {
    const FilterQuadratic of{any(9), any(9), any(9), any(2), any(2), any(2), 0};
    const double x = any(9);
    const double y = any(9);
    const PlaceRect over{x, y, x + 3, y + 5};
    double most = of.c;
    double fewest = of.c;
    constexpr int cells = 60;
    for (int i = 0; i <= cells; ++i) {
      for (int j = 0; j <= cells; ++j) {
        const double px = x + 3.0 * i / cells;
        const double py = y + 5.0 * j / cells;
        const double value = of.c + of.x * px + of.y * py + of.xx * px * px + of.xy * px * py + of.yy * py * py;
        most = i + j == 0 ? value : std::max(most, value);
        fewest = i + j == 0 ? value : std::min(fewest, value);
      }
    }
    // The grid misses an extremum by at most half a cell.
    RC_ASSERT(judges::maximum(of, over) >= most - 1e-9);
    RC_ASSERT(judges::maximum(of, over) <= most + 0.05);
    RC_ASSERT(judges::minimum(of, over) <= fewest + 1e-9);
    RC_ASSERT(judges::minimum(of, over) >= fewest - 0.05);
  }));
}

TEST_CASE("a sphere's reach surrounds its outline and is clipped to the picture") {
  const auto reach = [](const glm::dvec3& centre, double radius, view::Projection projection) {
    const Scenery scenery = make_curved_scenery(ball(centre, radius, 64), straight_camera(40, projection), {60, 40});
    const judges::ExactCamera camera(scenery.camera, 60, 40, {projection == view::Projection::perspective, 1, 1000});
    return judges::quadric_reaches(scenery.scene, camera).front();
  };
  // Places are half pixels; the margin is two pixels, and the hull is a twentieth larger.
  const PlaceRect orthographic = reach({5, 0, 0}, 10, view::Projection::orthographic);
  CHECK(orthographic.x0 <= 2 * -5);
  CHECK(orthographic.x0 >= 2 * -8);
  CHECK(orthographic.x1 >= 2 * 15);
  CHECK(orthographic.x1 <= 2 * 18);
  CHECK(orthographic.y0 <= 2 * -10);
  CHECK(orthographic.y1 <= 2 * 13);
  const PlaceRect around = reach({0, -straight_distance(40), 0}, 50, view::Projection::perspective);
  CHECK(around.x0 == -60);
  CHECK(around.y1 == 40);
}
