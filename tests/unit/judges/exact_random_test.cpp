#include <rapidcheck.h>

#include "tests/numerics/solids.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/rational_oracle.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using namespace judges;
using view::Projection;

namespace {

std::size_t covered(const Truth& truth) {
  return truth.owner.size() - static_cast<std::size_t>(std::count(truth.owner.begin(), truth.owner.end(), nothing));
}

/// Random non-empty models, judged pixel by pixel in rational arithmetic.
void check_models(const view::Camera& camera, std::uint64_t seed, int models) {
  // Odd, so that pixel centres lie on faces; larger than a tile.
  constexpr Size size{11, 7};
  constexpr double near = 0.5;
  for (int judged = 0; judged < models; ++seed) {
    const Scenery scenery = make_scenery(random_model(seed, 2 + static_cast<unsigned>(seed % 3)), camera, size, near);
    const Truth truth = exact(scenery);
    if (covered(truth) < 15) continue;
    ++judged;
    CAPTURE(seed);
    CHECK(truth.owner == rational_owners(scenery.tree, scenery.scene, camera, size.width, size.height, near));
    for (std::uint32_t i = 0; i < truth.owner.size(); ++i) {
      if (truth.owner[i] == nothing) continue;
      const double expected = distance_in_doubles(scenery, i % size.width, i / size.width, truth.owner[i]);
      CHECK(truth.distance[i] == doctest::Approx(expected).epsilon(1e-9));
    }
  }
}

}  // namespace

TEST_CASE("the exact judge matches rational arithmetic on random models") {
  check_models({{15, -22, 17}, {0, 0, 0}, Projection::orthographic}, 1, testing::cases(2, 1));
  check_models({{15, -22, 17}, {0, 0, 0}, Projection::perspective}, 101, testing::cases(2, 1));
}
TEST_CASE("the exact judge matches rationals on models with edge-on faces at pixel centres") {
  check_models({{0, -30, 0}, {0, 0, 0}, Projection::orthographic}, 201, testing::cases(4, 1));
  check_models({{0, 0, 30}, {0, 0, 0}, Projection::orthographic}, 301, testing::cases(4, 1));
  check_models({{0, -25, 0}, {0, 0, 0}, Projection::perspective}, 401, testing::cases(4, 1));
}
TEST_CASE("the exact judge matches rational arithmetic on random models around the eye") {
  check_models({{0.25, -1, 0.5}, {0, 3, 0}, Projection::perspective}, 501, testing::cases(2, 1));
}
TEST_CASE("the exact judge orders nearly coincident faces of rotated boxes") {
  CHECK(rc::check([] {
    std::vector<std::string> boxes;
    for (int i = 0; i < 3; ++i) {
      const double about_x = *rc::gen::inRange(0, 3600) / 10.0;
      const double about_z = *rc::gen::inRange(0, 3600) / 10.0;
      const double size = *rc::gen::inRange(2, 5);
      boxes.push_back(with_transform(rotation(about_x, about_z), box({0, 0, 0}, {size, 3, 3})));
    }
    const auto projection = *rc::gen::element(Projection::orthographic, Projection::perspective);
    const view::Camera camera{{15, -22, 17}, {0, 0, 0}, projection};
    const std::string model = *rc::gen::element(unite(boxes), subtract(boxes));
    const Scenery scenery = make_scenery(model, camera, {1, 1});
    RC_ASSERT(exact(scenery).owner == rational_owners(scenery.tree, scenery.scene, camera, 1, 1, scenery.near));
  }));
}
