#include <rapidcheck.h>

#include "host/read/read.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/support/drawing.h"
#include "tests/support/software_ways.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using testing::all_variants;
using testing::MethodVariant;
using testing::Scene;
using testing::SoftwareScene;

namespace {

/// Counts of random scenes and pixels.
struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t empty = 0;  ///< scenes without visible pixels
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;
  std::vector<std::uint64_t> drawn_by = std::vector<std::uint64_t>(all_variants().size());
};

void count(const std::vector<testing::Seen>& expected, Tally& tally) {
  std::uint64_t covered = 0;
  for (const testing::Seen& seen : expected) covered += seen.owner != 0xffffffffU ? 1U : 0U;
  tally.pixels += expected.size();
  tally.covered += covered;
  tally.empty += covered == 0 ? 1U : 0U;
}

/// Returns the fault of a scene in `ways` of all ways, chosen by the seed; empty if none.
std::string find_fault(std::uint64_t seed, std::size_t ways, Tally& tally) {
  const std::optional<Scene> scene = testing::random_scene(seed);
  ++tally.scenes;
  tally.refused += scene ? 0U : 1U;
  if (!scene) return "";
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene->tree, scene->geometry, scene->view);
  count(expected, tally);
  const SoftwareScene software(scene->tree, scene->geometry, scene->view);
  for (std::size_t i = 0; i < ways; ++i) ++tally.drawn_by[(seed * ways + i) % all_variants().size()];
  const std::string fault = software.describe_some_mismatch(seed, ways, expected);
  return fault.empty() ? fault : "seed " + std::to_string(seed) + ", " + fault;
}

void check_all_ways(const Scene& scene) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  const SoftwareScene software(scene.tree, scene.geometry, scene.view);
  for (const MethodVariant& way : all_variants()) {
    if (!software.is_too_deep(way)) CHECK(software.describe_mismatch(way, expected) == "");
  }
}

view::Sampling picture_of(std::uint32_t width, std::uint32_t height) {
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  return sampling;
}

Scene build_scene(const std::string& csg, const view::Camera& camera, const view::Sampling& sampling) {
  return testing::make_scene(read::read_csg_text(csg, "test"), camera, sampling);
}

const view::Camera aside{{18, -25, 21}, {0, 0, 0}, view::Projection::perspective};

}  // namespace

TEST_CASE("a random sample of software methods draws random models as the judge does") {
  constexpr std::size_t scenes = 24;
  constexpr std::size_t ways = 8;
  Tally tally;
  CHECK(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    for (std::uint64_t i = 0; i < scenes; ++i) {
      const std::string fault = find_fault(seed + i, ways, tally);
      if (!fault.empty()) RC_FAIL(fault);
    }
  }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.empty, " empty, ", tally.covered, " of ",
          tally.pixels, " pixels covered");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.refused < tally.scenes / 10);
  CHECK(tally.empty < tally.scenes / 2);
  CHECK(tally.covered > tally.pixels / 20);
  for (const std::uint64_t times : tally.drawn_by) CHECK(times > 20);
}
TEST_CASE("all software methods draw random models as the rule-based judge does") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) CHECK(find_fault(seed, all_variants().size(), tally) == "");
  CHECK(tally.covered > tally.pixels / 20);
}
TEST_CASE("all software methods draw the thesis's objects as the rule-based judge does") {
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      check_all_ways(testing::thesis_scene(one, 45, 37));
    }
  }
}
TEST_CASE("software methods draw nothing for an empty model") {
  for (const char* const csg : {"union(){}", "difference(){}"})
    check_all_ways(build_scene(csg, aside, picture_of(20, 9)));
}
TEST_CASE("software methods draw nothing for objects behind the eye") {
  const Scene scene = build_scene("cube(size=[4,4,4],center=true);",
                                  {{18, -25, 21}, {36, -50, 42}, view::Projection::perspective}, picture_of(20, 9));
  check_all_ways(scene);
}
TEST_CASE("software methods draw one pixel as the rule-based judge does") {
  check_all_ways(
      build_scene("difference(){cube(size=[4,4,4],center=true);sphere($fn=12,r=2.5);}", aside, picture_of(1, 1)));
}
TEST_CASE("software methods draw one cube and two separate cubes as the judge does") {
  check_all_ways(build_scene("cube(size=[4,4,4],center=true);", aside, picture_of(70, 50)));
  check_all_ways(
      build_scene("multmatrix([[1,0,0,-6],[0,1,0,-6],[0,0,1,0],[0,0,0,1]]){cube(size=[4,4,4],center=true);}"
                  "multmatrix([[1,0,0,4],[0,1,0,3],[0,0,1,0],[0,0,0,1]]){cube(size=[4,4,4],center=true);}",
                  aside, picture_of(70, 50)));
}
TEST_CASE("primitives that contain a cell of the picture do not affect adjacent cells") {
  view::Sampling sampling = picture_of(48, 48);
  sampling.z_bits = 8;
  sampling.fraction_bits = 0;
  const view::Camera camera{{0, -12 / view::half_height_per_distance(), 0}, {0, 0, 0}, view::Projection::orthographic};
  check_all_ways(build_scene(
      "intersection(){multmatrix([[1,0,0,0],[0,1,0,-8],[0,0,1,-32],[0,0,0,1]]){cube(size=[16,32,48],center=false);}"
      "multmatrix([[1,0,0,-24],[0,1,0,-4],[0,0,1,-32],[0,0,0,1]]){cube(size=[64,8,24],center=false);}}",
      camera, sampling));
}
TEST_CASE("a union's surface is seen where a subtracted back face ends at it") {
  const view::Camera camera{{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic};
  const Scene scene = build_scene(
      "difference(){union(){multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=[16,16,16],center=true);}"
      "multmatrix([[1,0,0,-4],[0,1,0,0],[0,0,1,-4],[0,0,0,1]]){cube(size=[8,4,8],center=false);}}"
      "multmatrix([[1,0,0,-9],[0,1,0,-9],[0,0,1,-9],[0,0,0,1]]){cube(size=[18,9,18],center=false);}}",
      camera, picture_of(21, 21));
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  CHECK(expected[21 * 10 + 10].owner == 1);
  CHECK(expected[21 * 10 + 5].owner == 2);
  check_all_ways(scene);
}
TEST_CASE("a software method draws the same picture whether it counts or not") {
  std::size_t number = 0;
  for (std::uint64_t seed = 1001; seed <= 1100; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene) continue;
    const SoftwareScene software(scene->tree, scene->geometry, scene->view);
    for (int i = 0; i < 8; ++i, ++number) {
      const MethodVariant& way = all_variants()[number % all_variants().size()];
      CAPTURE(seed);
      CAPTURE(testing::to_text(way));
      const std::unique_ptr<software::Method> counts = software.make(way, true);
      const std::unique_ptr<software::Method> plain = software.make(way, false);
      CHECK((software::draw(software.rays(), *counts).seen == software::draw(software.rays(), *plain).seen));
      software::Counts nothing;
      nothing.words = counts->counts().words;
      CHECK(plain->counts().words == nothing.words);
      CHECK(plain->counts().operations == software::Operations{});
      CHECK(plain->counts().points + plain->counts().evaluations + plain->counts().looked_up == 0);
      CHECK(plain->counts().node_visits + plain->counts().list_steps + plain->counts().pruned_nodes == 0);
    }
  }
}
