#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/read/read.h"
#include "hw/kinds/load.h"
#include "sim/studies/accuracy/measure.h"
#include "sim/studies/accuracy/settings.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t side = 96;
const view::Camera camera{{40, -60, 45}, {0, 0, 0}, view::Projection::orthographic};
const char* const joined_balls =
    "sphere($fn=16,$fa=12,$fs=2,r=9);multmatrix([[1,0,0,8],[0,1,0,-6],[0,0,1,5],[0,0,0,1]]){"
    "sphere($fn=16,$fa=12,$fs=2,r=6);}";

machines::Machine machine_of(const std::string& name) {
  machines::Machine machine = kinds::load(name);
  machine.array = {side, side, session::ample_memory_bits};
  return machine;
}

view::Sampling sampling() {
  view::Sampling sampling;
  sampling.width = sampling.height = side;
  return sampling;
}

const studies::CurvesChoice& choice(emit::Curves curves) {
  const auto found = std::ranges::find(studies::curves_choices(), curves, &studies::CurvesChoice::curves);
  REQUIRE(found != studies::curves_choices().end());
  return *found;
}

/// Settings that request curved surfaces instead of `base`.
studies::Settings drawn_as(emit::Curves curves, const facet::Faceting& base = {}) {
  return {"curves", std::string(emit::name_of(curves)), choice(curves).faceting(base), sampling()};
}

std::optional<std::string> why_not(emit::Curves curves, const std::string& csg, const view::Camera& seen_by,
                                   const std::string& machine) {
  const model::Tree tree = read::read_csg_text(csg, "test");
  const emit::Options options;
  const emit::Look look = emit::make_look(options.scene, tree, csg::make_positive_tree(tree), seen_by);
  return choice(curves).why_not({tree, seen_by, machine_of(machine), options, look});
}

}  // namespace

TEST_CASE("fast spheres have true outlines and edges but other depths") {
  const model::Tree tree = read::read_csg_text(joined_balls, "test");
  studies::Meter meter(tree, studies::rotated_cameras(camera, 2), machine_of("pixel-planes-4"), {});
  const studies::Measurement facets = meter.measure(drawn_as(emit::Curves::facets));
  const studies::Measurement fast = meter.measure(drawn_as(emit::Curves::fast));
  CHECK(fast.halfspaces == 2);
  CHECK(fast.clocks * 5 < facets.clocks);
  CHECK(facets.unexplained == 0);
  CHECK(fast.wrong_silhouette <= 2);
  CHECK(fast.wrong_owner > 20);
  CHECK(fast.facet_wrong >= fast.wrong_owner);
  // Off by at most 0.3 of the greater radius; at the deepest place by at least 0.2 of it.
  CHECK(fast.facet_depth_p999 < 0.3 * 9);
  CHECK(fast.facet_depth_p999 > 0.2 * 9);
}

TEST_CASE("a sphere beyond the machine's numbers is faceted among fast ones") {
  const std::string small = "sphere($fn=16,$fa=12,$fs=2,r=5);";
  const std::string cut = "intersection(){cube(size=20,center=true);sphere($fn=16,$fa=12,$fs=2,r=20000);}";
  const auto halfspaces = [&](const std::string& csg, emit::Curves curves) {
    const model::Tree tree = read::read_csg_text(csg, "test");
    studies::Meter meter(tree, {camera}, machine_of("pixel-planes-4"), {});
    return meter.measure(drawn_as(curves)).halfspaces;
  };
  const std::uint64_t of_small = halfspaces(small, emit::Curves::facets);
  CHECK(of_small > 20);
  CHECK(halfspaces(small, emit::Curves::fast) == 1);
  CHECK(halfspaces(small + cut, emit::Curves::fast) == halfspaces(small + cut, emit::Curves::facets) - of_small + 1);
}

TEST_CASE("a Meter distinguishes pictures of equal size with different faceting") {
  const model::Tree tree = read::read_csg_text(joined_balls, "test");
  studies::Meter meter(tree, {camera}, machine_of("pixel-powers"), {});
  for (const emit::Curves curves : {emit::Curves::fast, emit::Curves::exact}) {
    studies::Settings settings = drawn_as(curves);
    CHECK(meter.measure(settings).halfspaces == 2);
    settings.faceting.faceted = {true, false};
    const std::uint64_t first = meter.measure(settings).halfspaces;
    CHECK(first > 2);
    settings.faceting.faceted = {true, true};
    CHECK(meter.measure(settings).halfspaces > first);
  }
}

TEST_CASE("points that vary curves ignore the faceting set for other points") {
  facet::Faceting fast = drawn_as(emit::Curves::fast).faceting;
  fast.faceted = {true};
  const facet::Faceting exact = drawn_as(emit::Curves::exact, fast).faceting;
  CHECK(exact.exact_curves);
  CHECK_FALSE(exact.fast_spheres);
  CHECK(exact.faceted.empty());
  const facet::Faceting facets = drawn_as(emit::Curves::facets, fast).faceting;
  CHECK_FALSE(facets.exact_curves);
  CHECK_FALSE(facets.fast_spheres);
  CHECK(drawn_as(emit::Curves::fast, exact).faceting.fast_spheres);
}

TEST_CASE("accuracy omits fast spheres with a reason if none can be drawn") {
  const std::string ball = "sphere($fn=16,$fa=12,$fs=2,r=9);";
  const std::string ellipsoid = "multmatrix([[2,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){" + ball + "}";
  const view::Camera near{camera.eye, camera.centre, view::Projection::perspective};
  CHECK_FALSE(why_not(emit::Curves::fast, ball, camera, "pixel-planes-4"));
  const auto in_perspective = why_not(emit::Curves::fast, ball, near, "pixel-planes-4");
  REQUIRE(in_perspective);
  CHECK(in_perspective->find("--projection ortho") != std::string::npos);
  const auto no_ball = why_not(emit::Curves::fast, ellipsoid, camera, "pixel-planes-4");
  REQUIRE(no_ball);
  CHECK(no_ball->find("no sphere") != std::string::npos);
  CHECK_FALSE(why_not(emit::Curves::exact, ellipsoid, near, "pixel-powers"));
  CHECK(why_not(emit::Curves::exact, ball, camera, "pixel-planes-4"));
}
