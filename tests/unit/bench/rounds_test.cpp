#include "tests/performance/rounds.h"

#include <nlohmann/json.hpp>

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/camera.h"
#include "tests/performance/povray.h"
#include "tests/performance/process.h"
#include "tests/performance/report.h"
#include "tests/performance/subjects.h"
#include "tests/support/test.h"

using namespace csgsim;

TEST_CASE("the median of an even count is the mean of the two middle values") {
  CHECK(bench::median({3}) == 3);
  CHECK(bench::median({9, 1, 4}) == 4);
  CHECK(bench::median({8, 1, 2, 4}) == 3);
  CHECK_THROWS_AS(bench::median({}), std::invalid_argument);
}

TEST_CASE("bench measures candidates in turns for the given rounds or until time is up") {
  std::string order;
  double slower = 0;
  const std::array<bench::Timed, 2> all{[&] {
                                          order += 'a';
                                          return 1.0;
                                        },
                                        [&] {
                                          order += 'b';
                                          return slower += 1.0;
                                        }};
  CHECK(bench::medians_in_turn(all, {3, 1000}) == std::vector<double>{1, 2});
  CHECK(order == "ababab");
  order.clear();
  bench::medians_in_turn(all, {1000, 0});
  CHECK(order == "ab");
}

TEST_CASE("bench measures another build after each candidate and reports ratios per round") {
  std::string order;
  // Both take twice as long in every second round.
  const auto timed = [&](char name, double seconds) -> bench::Timed {
    return [&order, name, seconds] {
      order += name;
      return order.size() % 8 <= 4 && order.size() % 8 > 0 ? seconds : 2 * seconds;
    };
  };
  const std::array<bench::Timed, 2> all{timed('a', 1), timed('b', 4)};
  const std::array<bench::Timed, 2> others{timed('A', 3), timed('B', 2)};
  const std::vector<bench::Compared> compared = bench::compare_in_turn(all, others, {2, 1000});
  CHECK(order == "aAbBaAbB");
  REQUIRE(compared.size() == 2);
  CHECK(compared[0].seconds == 1.5);
  REQUIRE(compared[0].other);
  CHECK(compared[0].other->seconds == 4.5);
  CHECK(compared[0].other->ratio == 3);
  REQUIRE(compared[1].other);
  CHECK(compared[1].other->ratio == 0.5);
  const std::vector<bench::Compared> alone = bench::compare_in_turn(all, {}, {1, 0});
  REQUIRE(alone.size() == 2);
  CHECK_FALSE(alone[0].other);
}

TEST_CASE("exponent() finds the exponent of a power law for any factor") {
  for (const double power : {-1.0, 0.0, 0.5, 2.0}) {
    std::vector<bench::Point> points;
    for (const double x : {1.0, 3.0, 10.0, 80.0}) points.push_back({x, 7 * std::pow(x, power)});
    const std::optional<double> found = bench::exponent(points);
    REQUIRE(found);
    CHECK(*found == doctest::Approx(power));
  }
}

TEST_CASE("reports of bench omit exponents fitted to fewer than three sizes") {
  CHECK(!bench::exponent(std::array<bench::Point, 2>{{{1, 1}, {2, 3}}}));
  CHECK(!bench::exponent(std::array<bench::Point, 3>{{{1, 1}, {2, 3}, {2, 4}}}));
  bench::Results results;
  results.growths = {{"threads", "run", "csgsim", {{1, 0.05}, {2, 0.03}}},
                     {"pixels", "run", "csgsim", {{1, 1}, {10, 10}, {100, 100}}}};
  const std::string tables = bench::to_tables(results);
  CHECK(tables.find("| threads | run | \u2013 | 1: 50, 2: 30 |") != std::string::npos);
  CHECK(tables.find("| pixels | run | 1.00 |") != std::string::npos);
  const std::string json = bench::to_json(results).dump();
  CHECK(json.find("exponent") == json.rfind("exponent"));
  const std::vector<plots::Plot> plots = bench::plots_of_growths(results.growths);
  REQUIRE(plots.size() == 2);
  CHECK(std::get<plots::Chart>(plots[0].content).series[0].name == "run");
  CHECK(std::get<plots::Chart>(plots[1].content).series[0].name == "run: exponent 1.00");
  const auto& points = std::get<plots::Chart>(plots[0].content).series[0].points;
  REQUIRE(points.size() == 2);
  CHECK(points[1].x == 2);
  CHECK(points[1].y == doctest::Approx(30));  // milliseconds
}

TEST_CASE("models generated for bench have the stated number of half-spaces") {
  const auto scene_of = [](const std::string& text) { return facet::make_geometry(read::read_csg_text(text, "made")); };
  for (const unsigned fragments : {8U, 31U, 32U}) {
    const facet::Geometry sphere = scene_of(bench::drilled_sphere(fragments));
    REQUIRE(sphere.solids.size() == 4);
    CHECK(sphere.solids[0].halfspaces.size() == bench::sphere_halfspaces(fragments));
  }
  CHECK(bench::sphere_halfspaces(32) == 482);
  for (const unsigned cubes : {1U, 4U, 7U, 64U}) {
    const facet::Geometry grid = scene_of(bench::grid_of_cubes(cubes));
    CHECK(grid.solids.size() == cubes);
    for (const facet::Convex& cube : grid.solids) CHECK(cube.halfspaces.size() == 6);
  }
  const facet::Geometry plate = scene_of(bench::drilled_plate(5, 24, 0.6));
  REQUIRE(plate.solids.size() == 6);
  CHECK(plate.solids[5].halfspaces.size() == 24 + 2);
  CHECK(scene_of(bench::deep_tree(50)).solids.size() == 50);
}

TEST_CASE("bench distinguishes finished processes from missing and failed programs") {
  const std::array<std::string, 2> sleeps{"sleep", "0.1"};
  const std::optional<bench::ProcessCost> took = bench::run_process(sleeps);
  REQUIRE(took);
  CHECK(took->wall >= 0.1);
  CHECK(took->processor < took->wall);
  CHECK(took->memory > 0);
  const std::array<std::string, 1> none{"no-such-program-anywhere"};
  CHECK_FALSE(bench::run_process(none));
  CHECK(bench::run_process_within(20, sleeps));
  CHECK_FALSE(bench::run_process_within(20, none));
  const std::array<std::string, 2> too_long{"sleep", "20"};
  CHECK_THROWS_WITH_AS(bench::run_process_within(1, too_long), "sleep: takes more than 1 s", InputError);
  const std::array<std::string, 2> fails{"ls", "/no/such/folder"};
  CHECK_THROWS_WITH_AS(bench::run_process(fails), doctest::Contains("ls: fails: "), InputError);
  CHECK_THROWS_WITH_AS(bench::run_process_within(20, fails), doctest::Contains("ls: fails: "), InputError);
}

TEST_CASE("the POV-Ray scene has the same bounded half-spaces and the same tree") {
  const model::Tree tree =
      read::read_csg_text("difference() { cube(size = 2, center = true); sphere($fn = 8, r = 1); }", "made");
  const facet::Geometry scene = facet::make_geometry(tree);
  const std::string text = bench::povray_scene(tree, scene, view::default_camera(scene.box, 64, 64));
  const auto count = [&](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
  };
  CHECK(count("difference {") == 1);
  CHECK(count("intersection {") == 2);
  CHECK(count("bounded_by {") == 2);
  CHECK(count("pigment { rgb <0.98, 0.84, 0.17> }") == 2);  // OpenSCAD's yellow: 249, 215 and 44 of 255
  CHECK(count("plane {") == 6 + bench::sphere_halfspaces(8));
  // Faces of the cube at x = 1 and x = -1: points below 1 along the normal are inside.
  CHECK(count("plane { <1, 0, 0>, 1 }") == 1);
  const std::size_t opposite = text.find("plane { <-1, ");
  REQUIRE(opposite != std::string::npos);
  CHECK(text.substr(opposite, text.find('}', opposite) - opposite).ends_with(">, 1 "));
}

TEST_CASE("the POV-Ray camera has the same axes and a field of view of 22.5 degrees") {
  const model::Tree tree = read::read_csg_text("cube(size = [2, 2, 2], center = true);", "m.csg");
  const std::string text =
      bench::povray_scene(tree, facet::make_geometry(tree), {.eye = {0, 0, 10}, .centre = {0, 0, 0}});
  std::array<double, 12> found{};
  const std::size_t at = text.find("location");
  REQUIRE(at != std::string::npos);
  REQUIRE(std::sscanf(text.c_str() + at,
                      "location <%lf, %lf, %lf> direction <%lf, %lf, %lf> right <%lf, %lf, %lf> up <%lf, %lf, %lf>",
                      &found[0], &found[1], &found[2], &found[3], &found[4], &found[5], &found[6], &found[7], &found[8],
                      &found[9], &found[10], &found[11]) == 12);
  constexpr double side = 3.978247348;  // 2 * 10 * tan(11.25 degrees)
  const std::array<double, 12> expected{0, 0, 10, 0, 0, -1, side, 0, 0, 0, side, 0};
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == doctest::Approx(expected[i]));
}
