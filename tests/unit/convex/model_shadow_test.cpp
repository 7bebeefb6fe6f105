#include "host/convex/shadow_volume.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convex/light.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using namespace convex;
using namespace testing;

namespace {

/// Checks that random points lie in the volume of a piece exactly if the ray to the light hits the model.
void check_shadows(const TestModel& model, const Light& light, testing::RandomPoints& random, int points) {
  std::vector<ShadowVolume> volumes;
  for (const convex::Piece& piece : model.pieces()) {
    volumes.push_back(convex::shadow_volume(piece.polytope, light, model.scene.planes));
  }
  for (int i = 0; i < points; ++i) {
    const glm::dvec3 point = random.around(model.scene.box);
    double lowest = 1e300;
    for (const ShadowVolume& volume : volumes) lowest = std::min(lowest, signed_distance(model, volume, point));
    const double inside = testing::longest_segment_inside(model, point, testing::end_of_segment(model, light, point));
    if (std::abs(lowest) < doubtful * model.scene.planes.diagonal() || (inside > 0.0 && inside < doubtful)) continue;
    REQUIRE((lowest < 0.0) == (inside > 0.0));
  }
}

}  // namespace

TEST_CASE("the shadow volumes of a model's pieces match rays through the model") {
  testing::RandomPoints random(42);
  for (std::uint64_t seed = 2000; seed < 2400; ++seed) {
    CAPTURE(seed);
    const TestModel model(testing::random_model(seed, 1 + static_cast<unsigned>(seed % 10)));
    if (model.scene.box.empty() || model.solids.empty()) continue;
    check_shadows(model, random_light(model, random), random, 40);
  }
}

TEST_CASE("the shadow volumes of the demo models match rays") {
  testing::RandomPoints random(43);
  for (const char* name : {"thesis_fig_2_3", "carburettor", "terrain_vehicle", "rietveld_house", "old_example002",
                           "old_example003", "old_example011"}) {
    CAPTURE(name);
    const TestModel model = testing::demo_model(name);
    check_shadows(model, {{1, -1, 2, 0}}, random, 60);
    check_shadows(model, random_light(model, random), random, 60);
  }
}

TEST_CASE("light passes through a hole in a box and nowhere else") {
  const TestModel model(
      "difference(){cube(size=[4,4,2],center=true);cylinder($fn=16,$fa=12,$fs=2,h=9,r1=1,r2=1,center=true);}");
  std::vector<ShadowVolume> volumes;
  for (const convex::Piece& piece : model.pieces()) {
    volumes.push_back(convex::shadow_volume(piece.polytope, {{0, 0, 1, 0}}, model.scene.planes));
  }
  const auto in_shadow = [&](const glm::dvec3& point) {
    return std::any_of(volumes.begin(), volumes.end(),
                       [&](const ShadowVolume& volume) { return signed_distance(model, volume, point) < 0.0; });
  };
  CHECK(!in_shadow({0, 0, -9}));
  CHECK(!in_shadow({0.9, 0, -9}));
  CHECK(in_shadow({1.1, 0, -9}));
  CHECK(in_shadow({0, 1.9, -9}));
  CHECK(!in_shadow({0, 2.1, -9}));
  CHECK(!in_shadow({1.1, 0, 9}));
}
