#include "sim/software/convert/bodies.h"

#include <glm/common.hpp>

#include "host/csg/positive_tree.h"
#include "host/facet/planes.h"
#include "host/model/tree.h"
#include "host/read/read.h"
#include "hw/base/work.h"
#include "sim/software/convert/exact_points.h"
#include "sim/software/convert/face_planes.h"
#include "sim/software/convert/fragments.h"
#include "sim/software/convert/side_by_side.h"
#include "sim/software/planes/whole_planes.h"
#include "tests/support/test.h"

using namespace csgsim;
namespace convert = software::convert;
using convert::Bodies;
using convert::Body;

namespace {

Bodies bodies_of(const std::string& csg) { return convert::make_bodies(read::read_csg_text(csg, "m.csg"), {}); }

std::string moved_by(double x, double y, double z, const std::string& what) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) + "],[0,0,1," + std::to_string(z) +
         "],[0,0,0,1]]){" + what + "}";
}

std::string turned_by_45(const std::string& what) {
  const std::string half_root = "0.70710678118654752";
  return "multmatrix([[" + half_root + ",-" + half_root + ",0,0],[" + half_root + "," + half_root +
         ",0,0],[0,0,1,0],[0,0,0,1]]){" + what + "}";
}

std::string cone(int corners) { return "cylinder($fn=" + std::to_string(corners) + ",$fa=12,$fs=2,h=2,r1=3,r2=0);"; }

/// Whether each body is whole, that is, none of its faces needs to be split.
std::vector<bool> unsplit_of(const std::string& csg) {
  const model::Tree tree = read::read_csg_text(csg, "m.csg");
  const Bodies bodies = convert::make_bodies(tree, {});
  return convert::side_by_side(bodies, csg::make_positive_tree(tree), {});
}

using Bits = std::vector<bool>;

glm::dvec3 corner_of(const Bodies& bodies, std::uint32_t plane, std::uint32_t before, std::uint32_t after) {
  software::Triple triple{plane, before, after};
  std::ranges::sort(triple);
  return bodies.reference + bodies.planes.exact_position(triple) * bodies.planes.unit();
}

}  // namespace

TEST_CASE("the body of a block has the hand-calculated planes and points") {
  // The point of the block nearest to the origin is (10, -3, 0).
  const Bodies bodies = bodies_of(moved_by(10, -5, 0, "cube([1,2,3]);"));
  CHECK(bodies.reference == glm::dvec3(10, -3, 0));
  CHECK(bodies.tolerance == doctest::Approx(1e-10 * std::sqrt(14.0)));
  REQUIRE(bodies.bodies.size() == 1);
  const Body& body = bodies.bodies[0];
  const double unit = bodies.planes.unit();
  CHECK(unit >= 6);  // twice the largest coordinate relative to the reference
  CHECK(unit <= 12);
  CHECK(bodies.faces.size() == 6);
  REQUIRE(body.faces.size() == 6);
  CHECK(body.vertices.size() == 8);
  CHECK(body.edges.size() == 12);
  CHECK(body.polygons.size() == 6);
  CHECK(body.corners.size() == 24);
  CHECK(body.sides.size() == 24);
  CHECK(glm::distance(body.middle * unit, glm::dvec3(0.5, -1, 1.5)) < 1e-12);
  CHECK(body.outer * unit == doctest::Approx(std::sqrt(14.0) / 2));
  CHECK(body.inner * unit == doctest::Approx(0.5));
  CHECK(body.outer * unit >= std::sqrt(14.0) / 2);
  CHECK(body.inner * unit <= 0.5);
  CHECK(glm::distance(body.box.low * unit, glm::dvec3(0, -2, 0)) < 1e-11);
  CHECK(glm::distance(body.box.high * unit, glm::dvec3(1, 0, 3)) < 1e-11);
  for (const convert::BodyFace& face : body.faces) {
    const auto sides = body.sides_of(face);
    REQUIRE(sides.size() == 4);
    const glm::dvec3 size = (face.box.high - face.box.low) * unit;
    CHECK(face.radius * unit == doctest::Approx(glm::length(size) / 2));
    for (std::size_t i = 0; i < 4; ++i) {
      // The first corner of a side lies on its plane and on that of the previous side.
      REQUIRE(sides[i].vertex < 8);
      CHECK(glm::distance(body.vertices[sides[i].vertex],
                          corner_of(bodies, face.halfspace.plane, sides[(i + 3) % 4].plane, sides[i].plane)) < 1e-11);
    }
  }
  for (const convert::BodyPolygon& polygon : body.polygons) {
    const auto corners = body.corners_of(polygon);
    REQUIRE(corners.size() == 4);
    const facet::Halfspace halfspace = body.faces[polygon.face].halfspace;
    const glm::dvec3 out = (halfspace.positive ? 1.0 : -1.0) * bodies.faces[halfspace.plane].normal;
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3& here = body.vertices[corners[i]];
      const glm::dvec3& next = body.vertices[corners[(i + 1) % 4]];
      const glm::dvec3& after = body.vertices[corners[(i + 2) % 4]];
      CHECK(glm::dot(glm::cross(next - here, after - next), out) > 0);
      CHECK(std::abs(bodies.faces[halfspace.plane].height(here - bodies.reference)) < 1e-12);
    }
  }
  for (const auto& edge : body.edges) {
    const glm::dvec3 way = glm::abs(body.vertices[edge[0]] - body.vertices[edge[1]]);
    CHECK(edge[0] < edge[1]);
    CHECK((way == glm::dvec3(1, 0, 0) || way == glm::dvec3(0, 2, 0) || way == glm::dvec3(0, 0, 3)));
  }
}

TEST_CASE("the merge tolerance depends on the diagonal and the smallest node width") {
  // The tolerance is 10^-10 of the diagonal or 10^-5 of the width, and at least 10^-24 of the diagonal.
  const auto tolerance = [](const std::string& csg) { return bodies_of(csg).tolerance; };
  CHECK(tolerance("cube([3,4,12]);") == doctest::Approx(13e-10));
  CHECK(tolerance("cube([30000,40000,120000]);") == doctest::Approx(13e-6));
  const std::string wide = "cube([30000,40000,120000]);";
  for (const char* const small : {"cube([0.1,2,3]);", "cube([2,0.1,3]);", "cube([3,2,0.1]);"}) {
    CAPTURE(small);
    CHECK(tolerance(wide + small) == doctest::Approx(1e-6));
    CHECK(tolerance(small + wide) == doctest::Approx(1e-6));
  }
  // A thin solid with a wide bounding box.
  CHECK(tolerance(wide + turned_by_45("cube([0.1,2,3]);")) == doctest::Approx(1e-6));
  CHECK(tolerance("cube([1e11,1e11,1e-9]);") == doctest::Approx(std::sqrt(2.0) * 1e-13));
}

TEST_CASE("a body stores its edges only if there are at most 200") {
  // A cone of n sides has n edges around its base and n up to its apex.
  CHECK(bodies_of(cone(100)).bodies[0].edges.size() == 200);
  CHECK(bodies_of(cone(101)).bodies[0].edges.empty());
  CHECK(bodies_of("cylinder($fn=66,$fa=12,$fs=2,h=2,r1=3,r2=3);").bodies[0].edges.size() == 198);
  CHECK(bodies_of("cylinder($fn=67,$fa=12,$fs=2,h=2,r1=3,r2=3);").bodies[0].edges.empty());
}

TEST_CASE("coplanar faces of bodies share a plane number") {
  // Shared planes: x = 1, and y and z at both ends.
  const Bodies bodies =
      bodies_of("cube([1,2,3]);" + moved_by(1, 0, 0, "cube([5,2,3]);") + moved_by(9, 0, 0, "cube([1,1,1]);"));
  CHECK(bodies.faces.size() == 3 + 4 + 2 + 2);
  const auto near = [&](std::size_t body) { return bodies.bodies_meeting(bodies.bodies[body].box); };
  CHECK(near(0) == std::vector<std::uint32_t>{0, 1});
  CHECK(near(1) == std::vector<std::uint32_t>{0, 1});
  CHECK(near(2) == std::vector<std::uint32_t>{2});
}

TEST_CASE("planes within tolerance are merged except opposite faces of one solid") {
  // The diagonal is 8 and the unit 16: spheres of radius 2 and 1 around the origin, tolerances 4e-12 and 1e-12.
  convert::FacePlanes planes(glm::dvec3(0), 8, 16);
  planes.begin({{0, 0, 0}, 2, 4e-12});
  CHECK(planes.add({{1, 0, 0}, -1}) == facet::Halfspace{0, true});
  CHECK(planes.add({{1, 0, 0}, -1}) == facet::Halfspace{0, true});
  CHECK(planes.add({{-1, 0, 0}, 1 + 0x1p-39}) ==
        facet::Halfspace{1, false});  // 1.8e-12 apart with the whole solid in between
  CHECK(planes.add({{1, 0, 0}, -1 - 0x1p-38}) == facet::Halfspace{0, true});  // 3.6e-12
  CHECK(planes.add({{1, 0, 0}, -1 - 0x1p-37}) == facet::Halfspace{2, true});  // 7.3e-12
  CHECK(planes.add({{-1, 0, 0}, 1}) == facet::Halfspace{0, false});           // the same plane with the opposite normal
  CHECK(planes.planes().size() == 3);
  planes.begin({{0, 0, 0}, 1, 1e-12});
  CHECK(planes.add({{-1, 0, 0}, 1 - 0x1p-41}) == facet::Halfspace{0, false});  // 0.5e-12, for another solid
  CHECK(planes.add({{0, 1, 0}, 0}) == facet::Halfspace{3, true});
  CHECK(planes.add({{0, -1, 0}, 0x1p-39}) == facet::Halfspace{4, false});
  // A rotated plane moves less within a sphere of radius 1 than within one of radius 2.
  planes.begin({{0, 0, 0}, 2, 1e-12});
  const double turn = 0x1p-40;  // 0.9e-12
  CHECK(planes.add({{0, 1, turn}, 0}) == facet::Halfspace{5, true});
  planes.begin({{0, 0, 0}, 1, 1e-12});
  CHECK(planes.add({{0, 1, turn}, 0}) == facet::Halfspace{3, true});
  // The same rotation about a distant centre.
  planes.begin({{0, 0, 4}, 1, 1e-12});
  CHECK(planes.add({{0, 1, 2 * turn}, 0}) == facet::Halfspace{6, true});
}

TEST_CASE("planes for conversion are stored relative to a reference point") {
  convert::FacePlanes planes({10, 20, 30}, 8, 16);
  planes.begin({{0, 0, 0}, 2, 1e-12});
  CHECK(planes.add({{0, 1, 0}, -21}) == facet::Halfspace{0, true});
  CHECK(planes.add({{0, 0, -1}, 28}) == facet::Halfspace{1, false});
  CHECK(planes.planes()[0].offset == -1);
  CHECK(planes.planes()[1].offset == 2);
  CHECK(planes.planes()[1].normal == glm::dvec3(0, 0, 1));
}

TEST_CASE("exactly equal points are merged and points on a line are ordered") {
  // Planes x = i / 16 for i from 0 to 4, then y = 0, z = 0, y = z, and x + y + z = 1 / 8, 1 / 8 + 2^-60.
  std::vector<facet::Plane> given;
  for (int i = 0; i < 5; ++i) given.push_back({{1, 0, 0}, -i / 16.0});
  given.insert(given.end(),
               {{{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {{0, 1, -1}, 0}, {{1, 1, 1}, -0.125}, {{1, 1, 1}, -0.125 - 0x1p-55}});
  const software::WholePlanes planes(given, {glm::dvec3(-0.5), glm::dvec3(0.5)});
  convert::ExactPoints points(planes);
  for (std::uint32_t i = 0; i < 5; ++i) CHECK(points.add({i, 5, 6}) == i);
  CHECK(points.add({2, 5, 6}) == 2);
  CHECK(points.add({2, 6, 7}) == 2);
  CHECK(points.add({5, 6, 8}) == 2);
  CHECK(points.add({6, 7, 8}) == 2);
  CHECK(points.add({5, 6, 9}) == 5);  // a distinct neighbour
  CHECK(points.positions().size() == 6);
  points.forget_planes();
  CHECK(points.add({3, 6, 7}) == 3);
  CHECK(points.add({3, 5, 7}) == 3);
  CHECK(points.positions()[3] * planes.unit() == glm::dvec3(3 / 16.0, 0, 0));
  CHECK(points.planes(3) == software::Triple{3, 5, 6});
  // The points strictly between two ends on the line y = 0, z = 0, from either end.
  const std::uint32_t off = points.add({2, 7, 9});
  CHECK(off == 6);
  const std::vector<std::uint32_t> all{4, 3, 2, 1, 0, 5, 6};
  using Numbers = std::vector<std::uint32_t>;
  CHECK(convert::points_between(planes, points, 0, 4, {5, 6}, all) == Numbers{1, 2, 5, 3});
  CHECK(convert::points_between(planes, points, 4, 0, {5, 6}, all) == Numbers{3, 5, 2, 1});
  CHECK(convert::points_between(planes, points, 1, 3, {5, 6}, all) == Numbers{2, 5});
  CHECK(convert::points_between(planes, points, 2, 5, {5, 6}, all).empty());
  CHECK(convert::points_between(planes, points, 3, 1, {5, 6}, Numbers{0, 1, 3, 4}).empty());
}

TEST_CASE("adjacent bodies in a plain union need no splitting") {
  const std::string cube = "cube([2,2,2]);";
  struct Row {
    std::string csg;
    Bits whole;
  };
  for (const Row& row :
       std::vector<Row>{{cube, {true}},
                        {cube + moved_by(5, 0, 0, cube), {true, true}},
                        {cube + moved_by(2, 0, 0, cube), {true, true}},  // share a face
                        {cube + moved_by(2, 1, 0, cube), {true, true}},  // share part of a face
                        {cube + moved_by(2, 2, 0, cube), {true, true}},  // share an edge
                        {cube + moved_by(2, 2, 2, cube), {true, true}},  // share a corner
                        {cube + moved_by(1, 0, 0, cube), {false, false}},
                        {cube + cube, {false, false}},
                        {cube + moved_by(1, 0, 0, cube) + moved_by(9, 0, 0, cube), {false, false, true}},
                        {cube + moved_by(2, 0, 0, cube) + moved_by(3, 0, 0, cube), {false, false, false}},
                        {"difference(){" + cube + moved_by(2, 0, 0, cube) + "}", {false, false}},
                        {"intersection(){" + cube + moved_by(1, 1, 1, cube) + "}", {false, false}},
                        {"difference(){" + cube + moved_by(5, 0, 0, cube) + "}", {false, false}},
                        // The edge of one lies on the face of the other, starting at (2, 1).
                        {cube + moved_by(2, 1, 0, turned_by_45(moved_by(0, -2, 0, cube))), {true, true}}}) {
    CAPTURE(row.csg);
    CHECK(unsplit_of(row.csg) == row.whole);
  }
}

TEST_CASE("a body whose polygons are unknown must be split and so must its neighbours") {
  const std::string cube = "cube([2,2,2]);";
  const model::Tree tree = read::read_csg_text(cube + moved_by(2, 0, 0, cube) + moved_by(9, 0, 0, cube), "m.csg");
  for (std::size_t unknown = 0; unknown < 3; ++unknown) {
    CAPTURE(unknown);
    Bodies bodies = convert::make_bodies(tree, {});
    bodies.bodies[unknown].polygons.clear();
    CHECK(convert::side_by_side(bodies, csg::make_positive_tree(tree), {}) ==
          Bits{unknown == 2, unknown == 2, unknown != 2});
  }
}

namespace {

std::vector<std::vector<convert::Fragment>> fragments_of(const model::Tree& tree, unsigned threads, const Work& work) {
  const Bodies bodies = convert::make_bodies(tree, {});
  std::vector<std::vector<convert::Fragment>> found;
  convert::find_fragments(
      bodies, csg::make_positive_tree(tree), Bits(bodies.bodies.size(), false),
      [&](std::span<const convert::Fragment> one) { found.emplace_back(one.begin(), one.end()); }, work, threads);
  return found;
}

}  // namespace

TEST_CASE("fragments are returned by body with back faces reversed") {
  // The second cube removes a corner of the first: three faces of each are whole and three are cut. The
  // fragments of the second cube are reversed, so that they face its interior.
  const model::Tree tree =
      read::read_csg_text("difference(){cube([4,4,4]);" + moved_by(2, 2, 2, "cube([4,4,4]);") + "}", "m.csg");
  const Bodies bodies = convert::make_bodies(tree, {});
  const auto found = fragments_of(tree, 1, {});
  REQUIRE(found.size() == 2);
  CHECK(found[1].size() == 3);
  CHECK(found[0].size() >= 6);
  double area = 0;
  for (std::uint32_t body = 0; body < 2; ++body) {
    for (const convert::Fragment& fragment : found[body]) {
      CHECK(fragment.body == body);
      std::vector<glm::dvec3> places;
      for (const convert::FragmentCorner& corner : fragment.corners)
        places.push_back(bodies.reference + bodies.planes.exact_position(corner.planes) * bodies.planes.unit());
      glm::dvec3 twice(0);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t next = (i + 1) % places.size();
        twice += glm::cross(places[i] - places[0], places[next] - places[0]);
        // The side to the next corner lies on a second plane that contains both corners.
        for (const convert::FragmentCorner* const end : {&fragment.corners[i], &fragment.corners[next]}) {
          const std::array on{fragment.plane, fragment.corners[i].along};
          CHECK(bodies.planes.is_on_all(end->planes, on));
        }
        const std::uint32_t vertex = fragment.corners[i].vertex;
        if (vertex != convert::no_vertex) CHECK(glm::distance(bodies.bodies[body].vertices[vertex], places[i]) < 1e-9);
      }
      CHECK(glm::dot(twice, bodies.faces[fragment.plane].normal) * (fragment.is_front ? 1.0 : -1.0) > 0);
      area += glm::length(twice) / 2;
    }
  }
  CHECK(area == doctest::Approx(6 * 16));
}

TEST_CASE("any number of threads finds the same fragments with the same work") {
  std::string csg;
  for (int i = 0; i < 12; ++i) csg += moved_by(i, 0.5 * i, 0.25 * i, "cube([3,3,3]);");
  const model::Tree tree = read::read_csg_text(csg, "m.csg");
  const Work alone(1'000'000'000);
  const auto expected = fragments_of(tree, 1, alone);
  CHECK(expected.size() == 12);
  for (const unsigned threads : {2U, 3U, 64U}) {
    CAPTURE(threads);
    const Work work(1'000'000'000);
    const auto found = fragments_of(tree, threads, work);
    REQUIRE(found.size() == 12);
    CHECK(work.done() == alone.done());
    for (std::size_t i = 0; i < 12; ++i) {
      REQUIRE(found[i].size() == expected[i].size());
      for (std::size_t k = 0; k < found[i].size(); ++k) {
        CHECK(found[i][k].plane == expected[i][k].plane);
        CHECK(found[i][k].body == i);
        CHECK(found[i][k].corners.size() == expected[i][k].corners.size());
      }
    }
    CHECK_THROWS_AS(fragments_of(tree, threads, Work(alone.done() - 1)), WorkError);
    CHECK_NOTHROW(fragments_of(tree, threads, Work(alone.done())));
  }
}
