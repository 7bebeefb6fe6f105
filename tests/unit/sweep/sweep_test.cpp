#include <doctest/doctest.h>

#include <map>

#include "hw/base/error.h"
#include "tests/unit/sweep/given.h"

using namespace csgsim;

namespace {

std::size_t pieces_of(const std::string& name) { return testing::swept(testing::read_given(name)).size(); }

const flat::Area& square() {
  static const flat::Area area{{{{1, 0}, {2, 0}, {2, 1}, {1, 1}}}};
  return area;
}

}  // namespace

TEST_CASE("an extrusion of a height of 0 or less is empty") {
  CHECK(pieces_of("l_none") == 0);
  CHECK(solids::linear_extrude(square(), {0}).empty());
  CHECK(solids::linear_extrude({}, {1}).empty());
}

TEST_CASE("a convex extrusion is one piece") {
  CHECK(pieces_of("box_wide") == 1);       // scaled along its sides
  CHECK(pieces_of("box_one_slice") == 1);  // twisted, all diagonals bulge out
}

TEST_CASE("an untwisted extrusion has one piece per convex part") {
  CHECK(pieces_of("l_prism") == 2);
  CHECK(pieces_of("l_center") == 2);  // slices do not bend it
}

TEST_CASE("a convex part that touches the axis is revolved as one piece") {
  CHECK(pieces_of("pawn_full") == 5);
  CHECK(pieces_of("pawn_quarter") == 5);
  CHECK(pieces_of("pawn_most") == 2 * 5);
}

TEST_CASE("a convex part away from the axis is revolved as one wedge per fragment") {
  CHECK(pieces_of("ring_full") == 9);
}

TEST_CASE("a profile on both sides of the axis is rejected with OpenSCAD's message") {
  const flat::Area area{{{{-1, 0}, {2, 0}, {2, 1}, {-1, 1}}}};
  CHECK_THROWS_WITH_AS(solids::rotate_extrude(area, {}),
                       "all points for rotate_extrude() must have the same X coordinate sign (range is -1.00 -> 2.00); "
                       "move the profile to one side of the Y axis, or cut it there",
                       InputError);
}

TEST_CASE("a revolution of 0 degrees or of half a turn in one fragment is empty") {
  CHECK(solids::rotate_extrude(square(), {0, {}}).empty());
  CHECK(solids::rotate_extrude(square(), {180, {3, 12, 2}}).empty());
}

TEST_CASE("an extrusion with too many slices or fragments or pieces is rejected") {
  CHECK_THROWS_AS(solids::linear_extrude(square(), {10, false, 1e9}), InputError);
  CHECK_THROWS_AS(solids::linear_extrude(square(), {10, false, 10, 400'000}), InputError);
  CHECK_THROWS_AS(solids::linear_extrude(square(), {10, false, 10, 4'000'000}), InputError);
  CHECK_THROWS_AS(solids::rotate_extrude(square(), {360, {1e6, 12, 2}}), InputError);
}
