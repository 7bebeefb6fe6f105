#include "host/flat/made.h"

#include "tests/support/test.h"
#include "tests/unit/flat/support.h"

using namespace csgsim;
using flat::check_matches_openscad;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
using Path = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("squares match OpenSCAD") {
  check_matches_openscad(flat::square({3, 2}, false), "square");
  check_matches_openscad(flat::square({3, 2.5}, true), "square_center");
}

TEST_CASE("circles have the corners of OpenSCAD") {
  check_matches_openscad(flat::circle(10, {}), "circle");
  check_matches_openscad(flat::circle(3, {.fn = 7}), "circle_7");
  check_matches_openscad(flat::circle(12.5, {.fn = 0, .fa = 1, .fs = 0.3}), "circle_fine");
}

TEST_CASE("2-D shapes without size are empty") {
  CHECK(flat::square({0, 1}, false).empty());
  CHECK(flat::square({1, -1}, true).empty());
  CHECK(flat::square({infinite, 1}, false).empty());
  CHECK(flat::circle(0, {}).empty());
  CHECK(flat::circle(-1, {}).empty());
  CHECK(flat::circle(infinite, {}).empty());
  CHECK(flat::circle(std::nan(""), {}).empty());
  CHECK(flat::polygon({}, {}).empty());
  CHECK(flat::polygon(std::array{glm::dvec2(0, 0), glm::dvec2(1, 0)}, {}).empty());
  CHECK(flat::polygon(std::array{glm::dvec2(0, 0), glm::dvec2(1, 1), glm::dvec2(2, 2)}, {}).empty());
}

TEST_CASE("polygons without paths use all points in either orientation") {
  std::vector<glm::dvec2> points{{0, 0}, {10, 0}, {10, 5}, {4, 2}, {0, 8}};
  check_matches_openscad(flat::polygon(points, {}), "polygon");
  check_matches_openscad(flat::polygon(std::vector(points.rbegin(), points.rend()), {}), "polygon");
}

TEST_CASE("polygons with crossing paths follow the even-odd rule") {
  const std::vector<glm::dvec2> nested{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {2, 2}, {8, 2}, {8, 8}, {2, 8}};
  check_matches_openscad(flat::polygon(nested, std::array{Path{0, 1, 2, 3}, Path{4, 5, 6, 7}}), "polygon_hole");
  const std::vector<glm::dvec2> crossing{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {3, 3}, {9, 3}, {9, 9}, {3, 9}};
  check_matches_openscad(flat::polygon(crossing, std::array{Path{0, 1, 2, 3}, Path{7, 6, 5, 4}}), "polygon_overlap");
  std::vector<glm::dvec2> star;
  for (int i = 0; i < 7; ++i) {
    const double angle = i * 6 * std::acos(-1.0) / 7;
    star.emplace_back(10 * std::cos(angle), 10 * std::sin(angle));
  }
  check_matches_openscad(flat::polygon(star, {}), "polygon_star");
}

TEST_CASE("a polygon that touches itself matches OpenSCAD") {
  const std::vector<glm::dvec2> points{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}, {0, 4}};
  check_matches_openscad(flat::polygon(points, {}), "polygon_touching");
}

TEST_CASE("a polygon path with a nonexistent point is rejected") {
  const std::vector<glm::dvec2> points{{0, 0}, {4, 0}, {4, 4}};
  CHECK_THROWS_WITH_AS(flat::polygon(points, std::array{Path{0, 1, 2}, Path{0, 3, 1}}),
                       "paths[1][1] of polygon() is 3, but there are 3 points; count them from 0", InputError);
}

TEST_CASE("coordinates beyond the range of Clipper are rejected") {
  CHECK_THROWS_AS(flat::polygon(std::array{glm::dvec2(0, 0), glm::dvec2(1e13, 0), glm::dvec2(0, 1)}, {}), InputError);
  CHECK_THROWS_AS(flat::polygon(std::array{glm::dvec2(0, 0), glm::dvec2(1, std::nan("")), glm::dvec2(0, 1)}, {}),
                  InputError);
}
