#include "sim/software/convert/triangulate.h"

#include <glm/vec2.hpp>

#include "sim/software/convert/polygons.h"
#include "sim/software/convert/side.h"
#include "sim/software/convert/surface.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/seats.h"

using namespace csgsim;
namespace convert = software::convert;
using convert::Outline;
using convert::Side;
using convert::Triangle;

namespace {

using Polygon = std::vector<std::uint32_t>;

void add_loop(const Polygon& round, std::vector<Side>& sides) {
  for (std::size_t i = 0; i < round.size(); ++i) sides.push_back({round[i], round[(i + 1) % round.size()]});
}

Outline outline_of(const glm::dvec3& outward, const std::vector<Polygon>& rounds) {
  Outline outline{outward, {}};
  for (const Polygon& round : rounds) add_loop(round, outline.sides);
  return outline;
}

std::vector<Side> sides_left(const std::vector<Triangle>& triangles) {
  std::vector<Side> sides;
  for (const Triangle& triangle : triangles) add_loop({triangle.begin(), triangle.end()}, sides);
  convert::cancel_opposite_sides(sides);
  return sides;
}

std::vector<Side> sides_left(const Outline& outline) {
  std::vector<Side> sides = outline.sides;
  convert::cancel_opposite_sides(sides);
  return sides;
}

double area(const std::vector<glm::dvec3>& points, const Triangle& triangle, const glm::dvec3& outward) {
  return glm::dot(glm::cross(points[triangle[1]] - points[triangle[0]], points[triangle[2]] - points[triangle[0]]),
                  outward) /
         2;
}

double area(const std::vector<glm::dvec3>& points, const std::vector<Triangle>& triangles, const glm::dvec3& outward) {
  double sum = 0;
  for (const Triangle& triangle : triangles) sum += area(points, triangle, outward);
  return sum;
}

double min_area(const std::vector<glm::dvec3>& points, const std::vector<Triangle>& triangles,
                const glm::dvec3& outward) {
  double least = 1e300;
  for (const Triangle& triangle : triangles) least = std::min(least, area(points, triangle, outward));
  return least;
}

std::vector<std::size_t> sizes_of(const std::vector<Polygon>& polygons) {
  std::vector<std::size_t> sizes;
  for (const Polygon& polygon : polygons) sizes.push_back(polygon.size());
  std::ranges::sort(sizes);
  return sizes;
}

std::vector<std::size_t> sizes_of(const std::string& csg) {
  return sizes_of(convert::polygons_of(testing::converted(csg)));
}

}  // namespace

TEST_CASE("triangles of outlines have the outlines' area for each direction of view") {
  struct Row {
    std::vector<glm::dvec2> places;
    std::vector<Polygon> rounds;
    std::size_t triangles;
    double area;
  };
  const std::vector<glm::dvec2> plate{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {4, 4}, {2, 4}};
  for (const Row& row :
       std::vector<Row>{{plate, {{0, 1, 2}}, 1, 18},
                        {plate, {{0, 1, 2, 3}}, 2, 36},
                        {plate, {{0, 1, 2, 3}, {4, 7, 6, 5}}, 8, 32},           // with a hole
                        {plate, {{0, 1, 2, 3}, {4, 5, 6, 7}}, 10 + 2, 36 + 4},  // covered twice in the middle
                        {plate, {{0, 1, 6}, {4, 5, 2, 7}}, 0, 0},               // crossing sides
                        {{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, {{0, 1, 2, 3, 4, 5}}, 4, 12},
                        {{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {4, 2}, {4, 4}, {2, 4}}, {{0, 1, 2, 3}, {2, 4, 5, 6}}, 4, 8},
                        {{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {5, 5}, {7, 5}, {7, 7}}, {{0, 1, 2, 3}, {4, 5, 6}}, 3, 6}}) {
    for (const testing::Seat& seat : testing::seats) {
      CAPTURE(row.triangles);
      CAPTURE(seat.outward.x);
      CAPTURE(seat.outward.y);
      CAPTURE(seat.outward.z);
      std::vector<glm::dvec3> points;
      for (const glm::dvec2& place : row.places) points.push_back(place.x * seat.right + place.y * seat.up);
      const Outline outline = outline_of(seat.outward, row.rounds);
      const std::vector<Triangle> triangles = convert::triangulate(points, outline);
      CHECK(sides_left(triangles) == sides_left(outline));
      if (row.triangles == 0) {
        CHECK(convert::triangulate_two_sided(points, outline) == std::nullopt);
        continue;
      }
      CHECK(triangles.size() == (row.triangles == 12 ? triangles.size() : row.triangles));
      CHECK(area(points, triangles, seat.outward) == doctest::Approx(row.area));
      CHECK(min_area(points, triangles, seat.outward) > 0.4);
      // The same outline with reversed sides has all triangles on the back.
      Outline back{seat.outward, {}};
      for (const Side& side : outline.sides) back.sides.push_back({side[1], side[0]});
      const std::optional<convert::TwoSidedTriangles> two = convert::triangulate_two_sided(points, back);
      REQUIRE(two.has_value());
      CHECK(two->front.empty());
      CHECK(area(points, two->back, seat.outward) == doctest::Approx(-row.area));
      CHECK(sides_left(two->back) == sides_left(back));
    }
  }
}

TEST_CASE("counter-clockwise loops face the front and clockwise loops the back") {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {5, 0, 0}, {8, 0, 0}, {8, 3, 0}};
  const glm::dvec3 z(0, 0, 1);
  const std::optional<convert::TwoSidedTriangles> both =
      convert::triangulate_two_sided(points, outline_of(z, {{0, 1, 2, 3}, {0, 1, 2, 3}, {4, 6, 5}}));
  REQUIRE(both.has_value());
  CHECK(both->front.size() == 4);
  CHECK(area(points, both->front, z) == doctest::Approx(8));
  CHECK(both->back.size() == 1);
  CHECK(area(points, both->back, z) == doctest::Approx(-4.5));
  // A loop and its reverse cancel.
  const std::optional<convert::TwoSidedTriangles> none =
      convert::triangulate_two_sided(points, outline_of(z, {{0, 1, 2}, {0, 2, 1}}));
  REQUIRE(none.has_value());
  CHECK(none->front.empty());
  CHECK(none->back.empty());
  // Collinear points have no area.
  const std::optional<convert::TwoSidedTriangles> line =
      convert::triangulate_two_sided(points, outline_of(z, {{0, 1, 4}, {0, 4, 1}}));
  CHECK((!line.has_value() || (line->front.empty() && line->back.empty())));
  // Two points with the same projection.
  std::vector<glm::dvec3> above = points;
  above[4] = {0, 0, 1};
  CHECK(convert::triangulate_two_sided(above, outline_of(z, {{0, 1, 2, 3}, {4, 5, 6}})) == std::nullopt);
}

TEST_CASE("a nearly straight corner produces no slivers") {
  // Corner 1 is a millionth below the side from 0 to 2; a fan from 0 would have a triangle of 2e-6.
  const std::vector<glm::dvec3> points{{0, 0, 0}, {2, -1e-6, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const glm::dvec3 z(0, 0, 1);
  for (std::uint32_t first = 0; first < 5; ++first) {
    // Repeated with the numbering starting at each corner.
    CAPTURE(first);
    std::vector<glm::dvec3> turned = points;
    std::rotate(turned.begin(), turned.begin() + first, turned.end());
    const std::vector<Triangle> triangles = convert::triangulate(turned, outline_of(z, {{0, 1, 2, 3, 4}}));
    CHECK(triangles.size() == 3);
    CHECK(min_area(turned, triangles, z) > 1);
  }
}

TEST_CASE("an outline with clear left turns becomes a fan from its smallest point") {
  const glm::dvec3 z(0, 0, 1);
  std::vector<glm::dvec3> hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0);
  CHECK(convert::triangulate(hexagon, outline_of(z, {{3, 4, 5, 0, 1, 2}})) ==
        std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
  // The sine of a turn must exceed a thousandth; at (2, -h) it is h. A fan from 0 has a triangle of area 2 h there.
  for (const double h : {0.0009, 0.0011}) {
    const std::vector<glm::dvec3> points{{0, 0, 0}, {2, -h, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    const double least = min_area(points, convert::triangulate(points, outline_of(z, {{0, 1, 2, 3, 4}})), z);
    if (h < 0.001) {
      CHECK(least > 1);
    } else {
      CHECK(least == doctest::Approx(2 * h));
    }
  }
}

TEST_CASE("a star that winds twice is not convex although it always turns left") {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 5; ++i)
    points.emplace_back(std::cos(i * 0.4 * std::numbers::pi), std::sin(i * 0.4 * std::numbers::pi), 0);
  // The result is empty, because sides of the star cross.
  const Outline star = outline_of({0, 0, 1}, {{0, 2, 4, 1, 3}});
  CHECK(convert::triangulate_two_sided(points, star) == std::nullopt);
  CHECK(sides_left(convert::triangulate(points, star)) == sides_left(star));
  // A loop of six corners that winds twice; the sum of x times the next y minus y times the next x is 48 + 48 + 24 + 12
  // + 12 + 24.
  const std::vector<glm::dvec3> spiral{{-6, -4, 0}, {6, -4, 0}, {0, 8, 0}, {-3, -2, 0}, {3, -2, 0}, {0, 4, 0}};
  const Outline twice = outline_of({0, 0, 1}, {{0, 1, 2, 3, 4, 5}});
  CHECK(area(spiral, convert::triangulate(spiral, twice), {0, 0, 1}) == doctest::Approx(168 / 2.0));
}

TEST_CASE("sides are chained into loops") {
  CHECK(convert::rounds_of(outline_of({0, 0, 1}, {{3, 1, 2}, {6, 5, 4}})) ==
        std::vector<Polygon>{{1, 2, 3}, {4, 6, 5}});
  CHECK(convert::rounds_of(outline_of({0, 0, 1}, {{1, 2, 3}, {1, 2, 3}})) == std::vector<Polygon>{{1, 2, 3, 1, 2, 3}});
  CHECK(convert::rounds_of(outline_of({0, 0, 1}, {{1, 2}})) == std::vector<Polygon>{{1, 2}});
  CHECK(convert::rounds_of(outline_of({0, 0, 1}, {})).empty());
  // A path that passes twice through a corner is one loop of six sides.
  CHECK(convert::rounds_of(outline_of({0, 0, 1}, {{1, 2, 3}, {1, 4, 5}})) == std::vector<Polygon>{{1, 2, 3, 1, 4, 5}});
}

TEST_CASE("is_flat() decides coplanarity exactly") {
  const auto is_flat = [](const std::vector<glm::dvec3>& points) {
    Polygon round;
    for (std::uint32_t i = 0; i < points.size(); ++i) round.push_back(i);
    return convert::is_flat(points, round);
  };
  const double more = std::nextafter(0.3, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    std::vector<glm::dvec3> points;
    for (const glm::dvec2& place : {glm::dvec2(0, 0), glm::dvec2(0.1, 0), glm::dvec2(0.1, 0.7), glm::dvec2(0, 0.7)}) {
      glm::dvec3 point(0);
      point[axis] = 0.3;
      point[(axis + 1) % 3] = place.x;
      point[(axis + 2) % 3] = place.y;
      points.push_back(point);
    }
    CHECK(is_flat(points));
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<glm::dvec3> bent = points;
      bent[i][axis] = more;
      CHECK(!is_flat(bent));
    }
  }
  // Points on x + y + z = 3, the first three of them collinear.
  CHECK(is_flat({{3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {0, 0, 3}, {1, 0, 2}}));
  CHECK(!is_flat({{3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {0, 0, 3}, {1, 0, 2.5}}));
  CHECK(!is_flat({{3, 0, 0}, {2, 1, 0}, {0, 1, 2}, {0, 0, 3.5}}));
  CHECK(is_flat({{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}));
  CHECK(is_flat({{1, 2, 3}, {2, 4, 6}, {3, 7, 9}}));
}

TEST_CASE("faces of a surface are whole polygons or triangles if they have holes") {
  using Sizes = std::vector<std::size_t>;
  CHECK(sizes_of("cube([1,2,3]);") == Sizes(6, 4));
  CHECK(sizes_of("cylinder($fn=5,$fa=12,$fs=2,h=2,r1=1,r2=1);") == Sizes{4, 4, 4, 4, 4, 5, 5});
  // Two bars at an angle have eight faces, two of them with six corners.
  CHECK(sizes_of("cube([1,4,1]);cube([4,1,1]);") == Sizes{4, 4, 4, 4, 4, 4, 6, 6});
  // A hole through a plate: each end face has eight triangles, and there are eight sides.
  Sizes holed(16, 3);
  holed.insert(holed.end(), 8, 4);
  CHECK(
      sizes_of("difference(){cube([3,3,1]);multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,-1],[0,0,0,1]]){cube([1,1,4]);}}") ==
      holed);
  // Two cubes with four common face planes.
  CHECK(sizes_of("cube([1,1,1]);multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube([1,1,1]);}") ==
        Sizes(12, 4));
}

TEST_CASE("self-touching or bent polygons stay triangulated") {
  // A plate with a triangular notch that shares a corner with it.
  const std::vector<glm::dvec3> plate{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}, {1, 2, 0}};
  const std::vector<Triangle> around{{0, 1, 4}, {1, 2, 4}, {4, 2, 5}, {5, 2, 3}, {5, 3, 0}};
  convert::Surface surface{plate, around, std::vector<std::uint32_t>(5, 0)};
  CHECK(sizes_of(convert::polygons_of(surface)) == std::vector<std::size_t>(5, 3));
  // The plate no longer touches itself without its last triangle.
  surface.triangles.pop_back();
  surface.outlines.pop_back();
  CHECK(sizes_of(convert::polygons_of(surface)) == std::vector<std::size_t>{6});
  surface.points[4].z = 0.5;
  CHECK(sizes_of(convert::polygons_of(surface)) == std::vector<std::size_t>(4, 3));
  // Two outlines make two polygons.
  surface.points[4].z = 0;
  surface.outlines = {0, 0, 1, 1};
  CHECK(sizes_of(convert::polygons_of(surface)) == std::vector<std::size_t>{4, 4});
}
