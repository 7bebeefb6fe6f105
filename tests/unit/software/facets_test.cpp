#include "sim/software/facets/facets.h"

#include "host/convex/polytope.h"
#include "host/read/read.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/rays/caster.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::Event;
using testing::Scene;

namespace {

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t events = 0;
  std::uint64_t facets = 0;
  std::uint64_t with_opposites = 0;
  std::uint64_t bounds = 0;
};

/// Events at each pixel by scan conversion of facets.
std::vector<std::vector<Event>> scan_converted(const software::ScreenFacets& facets, std::uint32_t width,
                                               std::uint32_t height) {
  std::vector<std::vector<Event>> events(std::size_t{width} * height);
  for (const software::ScreenFacet& facet : facets.facets) {
    for (std::int32_t y = facet.pixels.y0; y <= facet.pixels.y1; ++y) {
      facets.for_row(facet, y, [&](std::int32_t x, const Event& event) {
        events[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)].push_back(event);
      });
    }
  }
  for (std::vector<Event>& one : events) std::sort(one.begin(), one.end());
  return events;
}

/// Returns the fault in the events of a scene's facets; empty if none. rays_test judges the rays.
std::string find_fault(const Scene& scene, Tally& tally) {
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  const software::Facets facets = software::facets_of(scene.tree, scene.geometry);
  const software::ScreenFacets seen = software::screen_facets(scene.tree, scene.geometry, scene.view, facets);
  const std::vector<std::vector<Event>> events = scan_converted(seen, rays.width(), rays.height());
  tally.facets += seen.facets.size();
  for (const software::ScreenFacet& facet : seen.facets) {
    tally.bounds += seen.bounds_of(facet).size();
    tally.with_opposites += seen.opposites_of(facet).empty() ? 0U : 1U;
  }
  software::RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band);
    for (std::size_t ray = 0; ray < band.rays(); ++ray) {
      const std::size_t pixel = std::size_t{row} * rays.width() + ray;
      if (!std::ranges::equal(band.events_of(ray), events[pixel]))
        return fmt::format("events at {}, {}", pixel % rays.width(), pixel / rays.width());
      tally.events += events[pixel].size();
    }
  }
  return "";
}

double area(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum{0};
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return glm::length(sum) / 2.0;
}

Scene build_scene(const std::string& csg) {
  model::Tree tree = read::read_csg_text(csg, "facets.csg");
  facet::Geometry geometry = facet::make_geometry(tree);
  return {std::move(tree), std::move(geometry), {}};
}

}  // namespace

TEST_CASE("scan-converted facets give each pixel its ray's events in random scenes") {
  Tally tally;
  CHECK(testing::holds_in_random_scenes(tally, testing::is_faceted, [&](const Scene& scene, std::uint64_t /*seed*/) {
    return find_fault(scene, tally);
  }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.events, " events, ", tally.facets, " facets, ",
          tally.with_opposites, " with opposites, ", tally.bounds, " bounds");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.refused < tally.scenes * 3 / 4);
  CHECK(tally.with_opposites > 0);
  CHECK(tally.with_opposites < tally.facets);
}
TEST_CASE("scan-converted facets give each pixel its ray's events on the thesis's objects") {
  Tally tally;
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(find_fault(testing::thesis_scene(one, 130, 45), tally) == "");
    }
  }
  CHECK(tally.bounds < 10 * tally.facets);
}
TEST_CASE("scan-converted solids of 400 or more faces give each pixel its ray's events") {
  Tally tally;
  const std::string ball = "sphere($fn=48,$fa=12,$fs=2,r=10);";
  const std::string rod = "cylinder($fn=400,$fa=12,$fs=2,h=20,r1=10,r2=9,center=true);";
  const std::string cone = "cylinder($fn=400,$fa=12,$fs=2,h=20,r1=10,r2=0,center=true);";
  const std::string sheet = "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,0.001,0],[0,0,0,1]]){" + ball + "}";
  for (const std::string& solid : {ball, rod, cone, sheet}) {
    for (const double size : {0.01, 0.2, 1.0}) {
      CAPTURE(solid);
      CAPTURE(size);
      testing::Setup how;
      how.camera = {{31, -47, 26}, {0, 0, 0}, view::Projection::perspective};
      how.sampling.width = 90;
      how.sampling.height = 80;
      for (const glm::dvec3 eye : {glm::dvec3{31, -47, 26}, glm::dvec3{0, 0, 60}, glm::dvec3{60, 0, 0}}) {
        how.camera.eye = eye;
        if (eye.x == 0.0) how.camera.up = {0, 1, 0};
        Scene scene =
            build_scene(fmt::format("union(){{multmatrix([[{0},0,0,0],[0,{0},0,0],[0,0,{0},0],[0,0,0,1]]){{{1}}}"
                                    "multmatrix([[1,0,0,12],[0,1,0,12],[0,0,1,12],[0,0,0,1]]){{cube(size=3);}}}}",
                                    size, solid));
        scene.view = view::make_view(scene.geometry, scene.tree, how.camera, how.sampling);
        CHECK(find_fault(scene, tally) == "");
      }
    }
  }
  MESSAGE(tally.events, " events, ", tally.facets, " facets, ", tally.bounds, " bounds");
  CHECK(tally.events > 20'000);
  CHECK(tally.facets > 3'000);
  CHECK(tally.bounds < 12 * tally.facets);
}
TEST_CASE("a primitive's facets are its solid's faces counter-clockwise from outside") {
  const Scene scene = build_scene("union() { cube([2, 3, 4]); cylinder(h = 5, r1 = 2, r2 = 2, $fn = 12); }");
  const software::Facets facets = software::facets_of(scene.tree, scene.geometry);
  REQUIRE(facets.of_primitives == std::vector<std::size_t>{0, 6, 20});
  CHECK(facets.polygon_count() == 20);
  double surface = 0;
  for (std::uint32_t i = 0; i < 6; ++i) surface += area(facets.corners_of(i));
  CHECK(surface == doctest::Approx(2.0 * (2 * 3 + 3 * 4 + 2 * 4)));
  double round = 0;
  for (std::uint32_t i = 6; i < 20; ++i) round += area(facets.corners_of(i));
  const double side = 4.0 * std::sin(std::acos(-1.0) / 12.0);
  CHECK(round == doctest::Approx(12.0 * side * 5.0 + 12.0 * 4.0 * std::sin(std::acos(-1.0) / 6.0)));
  for (std::uint32_t i = 0; i < 20; ++i) {
    const std::span<const glm::dvec3> corners = facets.corners_of(i);
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const facet::Halfspace halfspace = facets.facets[i].halfspace;
    const glm::dvec3 outward =
        scene.geometry.planes.planes()[halfspace.plane].normal * (halfspace.positive ? 1.0 : -1.0);
    CHECK(glm::dot(normal, outward) > 0.0);
  }
}
TEST_CASE("facets of a primitive that stays curved are rejected with its place") {
  const model::Tree tree = read::read_csg_text("\nsphere(r = 3);", "round.csg");
  facet::Faceting faceting;
  faceting.exact_curves = true;
  const facet::Geometry geometry = facet::make_geometry(tree, faceting);
  REQUIRE(!geometry.solids[0].quadrics.empty());
  const std::string error = testing::error_of([&] { (void)software::facets_of(tree, geometry); });
  CHECK(error.starts_with("round.csg:2:1: this primitive stays curved"));
}
