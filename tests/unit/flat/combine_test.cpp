#include "host/flat/combine.h"

#include <glm/ext/matrix_transform.hpp>

#include "host/flat/hull.h"
#include "host/flat/made.h"
#include "host/flat/minkowski.h"
#include "host/flat/offset.h"
#include "host/flat/place.h"
#include "tests/support/test.h"
#include "tests/unit/flat/support.h"

using namespace csgsim;
using namespace flat;

namespace {

Area moved(const Area& area, double x, double y) {
  return flat::transformed(area, glm::translate(glm::dmat4(1), glm::dvec3(x, y, 0)));
}

Area ell() {
  return flat::polygon(std::array<glm::dvec2, 6>{{{0, 0}, {10, 0}, {10, 3}, {3, 3}, {3, 10}, {0, 10}}}, {});
}

Area dart() { return flat::polygon(std::array<glm::dvec2, 4>{{{0, 0}, {10, 0}, {3, 3}, {0, 10}}}, {}); }

Area rectangle(double width, double height) { return flat::square({width, height}, false); }

}  // namespace

TEST_CASE("Boolean operations on areas match OpenSCAD") {
  check_matches_openscad(flat::unite(std::array{rectangle(3, 2), moved(flat::circle(1.5, {.fn = 32}), 2.3, 1.1),
                                                moved(rectangle(1, 1), -4, 0)}),
                         "union");
  check_matches_openscad(flat::subtract(std::array{flat::circle(10, {.fn = 48}), rectangle(6, 6),
                                                   moved(flat::circle(2, {.fn = 12}), -4, -3)}),
                         "difference");
  check_matches_openscad(
      flat::intersect(std::array{flat::circle(10, {.fn = 48}), moved(flat::circle(10, {.fn = 31}), 3, 0),
                                 moved(flat::square({20, 9}, true), 0, -4)}),
      "intersection");
}

TEST_CASE("combining a single area returns its exact coordinates") {
  const std::array alone{flat::circle(1.0 / 3, {})};
  CHECK(flat::unite(alone).outlines == alone[0].outlines);
  CHECK(flat::subtract(alone).outlines == alone[0].outlines);
  CHECK(flat::intersect(alone).outlines == alone[0].outlines);
  CHECK(flat::minkowski(alone).outlines == alone[0].outlines);
}

TEST_CASE("empty areas add nothing to unions and hulls and make intersections empty") {
  const std::array first_empty{Area{}, rectangle(1, 1)};
  const std::array last_empty{rectangle(1, 1), Area{}};
  for (const auto& areas : {first_empty, last_empty}) {
    CHECK(flat::area_of(flat::unite(areas)) == 1);
    CHECK(flat::intersect(areas).empty());
    CHECK(flat::minkowski(areas).empty());
    CHECK(flat::area_of(flat::hull(areas)) == 1);
  }
  CHECK(flat::subtract(first_empty).empty());
  CHECK(flat::area_of(flat::subtract(last_empty)) == 1);
  CHECK(flat::unite({}).empty());
  CHECK(flat::hull({}).empty());
  CHECK(flat::offset({}, 1, flat::Corner::round, {}).empty());
  CHECK(flat::resized({}, {1, 1}, {true, true}).empty());
}

TEST_CASE("hulls of areas match OpenSCAD") {
  check_matches_openscad(
      flat::hull(std::array{flat::circle(3, {.fn = 20}), moved(rectangle(2, 2), 10, 4), moved(rectangle(1, 1), 5, 1)}),
      "hull");
}

TEST_CASE("Minkowski sums of areas match OpenSCAD") {
  const Area frame = flat::subtract(std::array{rectangle(20, 12), moved(rectangle(12, 6), 3, 3)});
  check_matches_openscad(flat::minkowski(std::array{frame, flat::circle(1, {.fn = 16})}), "minkowski");
  const Area kite = flat::polygon(std::array<glm::dvec2, 4>{{{0, 0}, {2, 1}, {0, 0.5}, {-1, 2}}}, {});
  check_matches_openscad(flat::minkowski(std::array{ell(), kite, moved(rectangle(0.5, 0.5), 30, 0)}),
                         "minkowski_concave");
}

TEST_CASE("a Minkowski sum of areas with too many sides is rejected") {
  const Area round = flat::circle(1, {.fn = 1001});
  CHECK_THROWS_AS(flat::minkowski(std::array{round, round}), InputError);
}

TEST_CASE("offsets of areas match OpenSCAD") {
  using flat::Corner;
  check_matches_openscad(flat::offset(ell(), 2, Corner::round, {.fn = 24}), "offset_round");
  check_matches_openscad(flat::offset(rectangle(20, 10), 7.5, Corner::round, {}), "offset_round_default");
  const Area disc = flat::subtract(std::array{flat::circle(10, {.fn = 60}), moved(rectangle(3, 3), 2, 1)});
  check_matches_openscad(flat::offset(disc, -1.5, Corner::round, {.fn = 40}), "offset_inwards");
  check_matches_openscad(flat::offset(dart(), 1.25, Corner::sharp, {}), "offset_delta");
  check_matches_openscad(flat::offset(dart(), 1.25, Corner::cut, {}), "offset_chamfer");
  check_matches_openscad(flat::offset(ell(), -0.8, Corner::sharp, {}), "offset_delta_inwards");
  check_matches_openscad(flat::offset(rectangle(10, 4.5), -2, Corner::sharp, {}), "offset_vanishing");
}

TEST_CASE("an offset may make an area vanish and an excessive offset is rejected") {
  CHECK(flat::offset(rectangle(1, 1), -0.6, flat::Corner::round, {}).empty());
  CHECK(flat::area_of(flat::offset(rectangle(1, 1), 0, flat::Corner::round, {})) == 1);
  CHECK_THROWS_AS(flat::offset(rectangle(1, 1), 1.1e7, flat::Corner::sharp, {}), InputError);
  CHECK_THROWS_AS(flat::offset(flat::circle(1, {.fn = 99'999}), 1, flat::Corner::round, {.fn = 99'999}), InputError);
}

TEST_CASE("the largest offset of the sharpest corner stays in the coordinate range") {
  const Area needle = flat::polygon(std::array<glm::dvec2, 3>{{{-1e12, 0}, {1e12, 0}, {1e12, 1e-3}}}, {});
  CHECK_NOTHROW(flat::offset(needle, 1e7, flat::Corner::sharp, {}));
}

TEST_CASE("deeply nested areas are combined") {
  Area nested;
  for (int i = 0; i < 2'000; ++i) {
    const double size = 1 + i;
    Area one = flat::square({2 * size, 2 * size}, true);
    nested.outlines.push_back(one.outlines[0]);
    if (i % 2 == 0) std::ranges::reverse(nested.outlines.back());
  }
  const std::array both{nested, flat::square({1e4, 1e4}, true), nested};
  CHECK(flat::area_of(flat::intersect(both)) == flat::area_of(nested));
}

TEST_CASE("the 2-D part of a matrix transforms an area and mirrored areas are reoriented") {
  const Area hook = flat::polygon(std::array<glm::dvec2, 5>{{{1, 0}, {10, 0}, {10, 3}, {3, 3}, {3, 10}}}, {});
  check_matches_openscad(flat::transformed(hook, glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1))), "mirrored");
  const Area frame = flat::subtract(std::array{rectangle(5, 5), moved(rectangle(2, 2), 1, 1)});
  const glm::dmat4 matrix(2, 0.25, 7, 0, 0.5, 1.5, 8, 0, 3, 5, 9, 0, 4, -6, 10, 1);
  check_matches_openscad(flat::transformed(frame, matrix), "multmatrix");
  CHECK(flat::transformed(frame, glm::scale(glm::dmat4(1), glm::dvec3(1, 0, 1))).empty());
  CHECK_THROWS_AS(flat::transformed(frame, glm::scale(glm::dmat4(1), glm::dvec3(1e308, 1, 1))), InputError);
}

TEST_CASE("resized areas match OpenSCAD") {
  check_matches_openscad(flat::resized(flat::circle(3, {.fn = 16}), {12, 5}, {false, false}), "resize");
  check_matches_openscad(flat::resized(rectangle(3, 2), {12, 0}, {true, true}), "resize_auto");
  check_matches_openscad(flat::resized(flat::square({3, 2}, true), {0, 7}, {false, false}), "resize_zero");
}

TEST_CASE("a distant or large area does not change coordinates of another near the origin") {
  for (const double far : {1e6, 1e9, 1e11, 9e11}) {
    CAPTURE(far);
    // The area below the line from (-far, -far) to (far, far + 3), which cuts the square starting at (0, 1.5).
    const Area half = flat::polygon(std::array<glm::dvec2, 3>{{{-far, -far}, {far, -far}, {far, far + 3}}}, {});
    const double rest = 8.5 * 8.5 / 2;
    CHECK(flat::area_of(flat::intersect(std::array{rectangle(10, 10), half})) ==
          doctest::Approx(100 - rest).epsilon(1e-5));
    CHECK(flat::area_of(flat::subtract(std::array{rectangle(10, 10), half})) == doctest::Approx(rest).epsilon(1e-5));
    // The offset of a near area is the same with and without the far area.
    const Area alone = flat::offset(rectangle(10, 4), 1.5, flat::Corner::round, {.fn = 24});
    const Area both = flat::offset(flat::unite(std::array{rectangle(10, 4), moved(rectangle(far / 2, 8), far / 4, 0)}),
                                   1.5, flat::Corner::round, {.fn = 24});
    CHECK(both.outlines.size() == 2);
    CHECK(std::ranges::find(both.outlines, alone.outlines.front()) != both.outlines.end());
  }
}

TEST_CASE("repeated areas count once in a union or difference") {
  const std::array rings{ell(), moved(dart(), 1, 1), ell(), moved(dart(), 1, 1), ell()};
  const Area once = flat::unite(std::span(rings).first(2));
  CHECK(flat::unite(rings).outlines == once.outlines);
  const std::array drilled{rectangle(12, 12), ell(), dart(), ell(), dart()};
  CHECK(flat::subtract(drilled).outlines == flat::subtract(std::span(drilled).first(3)).outlines);
}
