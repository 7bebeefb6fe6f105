#include <rapidcheck.h>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "host/facet/solid.h"
#include "host/model/degrees.h"
#include "host/model/fragments.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

model::Primitive primitive(model::Shape shape) { return {std::move(shape), glm::dmat4(1.0), std::nullopt, {}}; }

glm::dmat4 turned(double angle, const glm::dvec3& shift, const glm::dvec3& scale) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {glm::dvec4(c * scale.x, s * scale.x, 0, 0), glm::dvec4(-s * scale.y, c * scale.y, 0.25 * scale.y, 0),
          glm::dvec4(0, 0, scale.z, 0), glm::dvec4(shift, 1)};
}

double real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }

model::Shape random_shape() {
  const model::FacetControl facets{static_cast<double>(*rc::gen::inRange(0, 40)), 12, 2};
  switch (*rc::gen::inRange(0, 3)) {
    case 0: return model::Cube{{real(1, 9), real(1, 9), real(1, 9)}, *rc::gen::arbitrary<bool>()};
    case 1: return model::Sphere{real(1, 30), facets};
    default: return model::Cylinder{real(1, 9), real(0, 5), real(1, 5), *rc::gen::arbitrary<bool>(), facets};
  }
}

model::Tree single(model::Primitive one) {
  model::Tree tree;
  tree.primitives.push_back(std::move(one));
  tree.nodes.push_back({true, model::Operator::unite, 0, {}});
  tree.root = 0;
  return tree;
}

}  // namespace

TEST_CASE("sine and cosine in degrees are exact where they are rational") {
  for (const int turns : {-2, 0, 1, 3}) {
    const double base = 360.0 * turns;
    CHECK(model::sin_degrees(base) == 0.0);
    CHECK(model::sin_degrees(base + 30) == 0.5);
    CHECK(model::sin_degrees(base + 90) == 1.0);
    CHECK(model::sin_degrees(base + 180) == 0.0);
    CHECK(model::sin_degrees(base + 210) == -0.5);
    CHECK(model::sin_degrees(base + 270) == -1.0);
    CHECK(model::cos_degrees(base) == 1.0);
    CHECK(model::cos_degrees(base + 60) == 0.5);
    CHECK(model::cos_degrees(base + 90) == 0.0);
    CHECK(model::cos_degrees(base + 180) == -1.0);
    CHECK(model::cos_degrees(base + 300) == 0.5);
  }
}

TEST_CASE("sine and cosine in degrees match the standard library for other angles") {
  for (int tenth = -7200; tenth <= 7200; tenth += 7) {
    const double angle = tenth / 10.0;
    CHECK(model::sin_degrees(angle) == doctest::Approx(std::sin(angle * std::numbers::pi / 180.0)).epsilon(1e-12));
    CHECK(model::cos_degrees(angle) == doctest::Approx(std::cos(angle * std::numbers::pi / 180.0)).epsilon(1e-12));
  }
}

TEST_CASE("circles have the number of fragments of OpenSCAD") {
  CHECK(model::fragments(10, {0, 12, 2}) == 30);   // 360 / $fa
  CHECK(model::fragments(5, {0, 12, 2}) == 16);    // 2 pi r / $fs = 15.7
  CHECK(model::fragments(0.5, {0, 12, 2}) == 5);   // $fa and $fs never yield fewer
  CHECK(model::fragments(10, {7.9, 12, 2}) == 7);  // $fn is truncated
  CHECK(model::fragments(10, {1, 12, 2}) == 3);
  CHECK(model::fragments(1e-7, {50, 12, 2}) == 3);
  CHECK(model::fragments(100, {0, 1, 0.01}) == 360);
}

TEST_CASE("circles with too many fragments are rejected") {
  CHECK_THROWS_AS(model::fragments(10, {1e9, 12, 2}), InputError);
}

TEST_CASE("solids have the half-spaces of OpenSCAD's facets") {
  const auto count = [](model::Shape shape) { return facet::make_solid(primitive(std::move(shape))).faces.size(); };
  CHECK(count(model::Cube{}) == 6);
  CHECK(count(model::Cylinder{2, 1, 1, false, {12, 12, 2}}) == 14);
  CHECK(count(model::Cylinder{2, 1, 0, false, {12, 12, 2}}) == 13);
  CHECK(count(model::Cylinder{2, 0, 1, false, {12, 12, 2}}) == 13);
  CHECK(count(model::Sphere{1, {8, 12, 2}}) == 8 * 3 + 2);
  CHECK(count(model::Sphere{1, {5, 12, 2}}) == 5 * 2 + 2);
}

TEST_CASE("every corner of a solid is inside all half-spaces and on the planes of its faces") {
  CHECK(rc::check([] {
    model::Primitive one = primitive(random_shape());
    const double mirror = *rc::gen::element(1.0, -1.0);
    one.transform = turned(real(0, 6), {real(-50, 50), real(-50, 50), real(-50, 50)},
                           {real(1, 4), mirror * real(1, 4), real(1, 4)});
    const facet::Solid solid = facet::make_solid(one);
    for (const facet::Face& face : solid.faces) {
      RC_ASSERT(std::abs(glm::length(face.plane.normal) - 1.0) < 1e-12);
      for (const glm::dvec3& vertex : solid.vertices) {
        RC_ASSERT(glm::dot(face.plane.normal, vertex) + face.plane.offset < 1e-10);
      }
      for (const std::uint32_t corner : face.corners) {
        RC_ASSERT(std::abs(glm::dot(face.plane.normal, solid.vertices[corner]) + face.plane.offset) < 1e-10);
      }
    }
  }));
}

TEST_CASE("each side of a solid's face is shared with exactly one other face") {
  CHECK(rc::check([] {
    const facet::Solid solid = facet::make_solid(primitive(random_shape()));
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faces_at;
    for (const facet::Face& face : solid.faces) {
      for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const auto [low, high] = std::minmax(face.corners[i], face.corners[(i + 1) % face.corners.size()]);
        if (low != high) ++faces_at[{low, high}];  // the apex of a cone occurs twice as a corner
      }
    }
    for (const auto& [side, faces] : faces_at) RC_ASSERT(faces == 2);
  }));
}

TEST_CASE("a solid with lengths below 1e-30 or above 1e90 is rejected") {
  const auto scaled_cube = [](double size, double scale) {
    model::Primitive one = primitive(model::Cube{glm::dvec3(size), true});
    one.transform = glm::dmat4(glm::dmat3(scale));
    return one;
  };
  for (const double length : {1e-29, 1e-9, 1.0, 1e89}) CHECK_NOTHROW(facet::make_solid(scaled_cube(1, length)));
  for (const double length : {1e-31, 1e91}) CHECK_THROWS_AS(facet::make_solid(scaled_cube(1, length)), InputError);
  CHECK_NOTHROW(facet::make_solid(scaled_cube(1e46, 1e43)));
  CHECK_THROWS_AS(facet::make_solid(scaled_cube(1e46, 1e46)), InputError);
}

TEST_CASE("coincident planes of either orientation share an entry of the plane table") {
  facet::PlaneTable table({1e6, -2e6, 3e6}, 10.0);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, -2));
  const facet::Halfspace first = table.add({normal, -glm::dot(normal, {1e6, -2e6, 3e6})});
  const facet::Halfspace again = table.add({normal, -glm::dot(normal, {1e6, -2e6, 3e6}) * (1.0 + 1e-17)});
  const facet::Halfspace opposite = table.add({-normal, glm::dot(normal, {1e6, -2e6, 3e6})});
  CHECK(first == again);
  CHECK(opposite.plane == first.plane);
  CHECK(opposite.positive != first.positive);
  CHECK(table.planes().size() == 1);
}

TEST_CASE("planes slightly apart are separate entries of the plane table") {
  facet::PlaneTable table({0, 0, 0}, 10.0);
  table.add({{0, 0, 1}, -1.0});
  table.add({{0, 0, 1}, -1.0 - 1e-9});
  table.add({glm::normalize(glm::dvec3(1e-9, 0, 1)), -1.0});
  CHECK(table.planes().size() == 3);
}

TEST_CASE("a plane shares the table entry of the first coincident plane") {
  constexpr double tolerance = facet::coincidence_tolerance;
  CHECK(rc::check([&] {
    // Values near 1 and near the boundaries of the grid's cells, in steps of a fraction of the tolerance.
    const double middle = *rc::gen::element(0.0, 0.5, 0x1p-32, 0x3p-32);
    const auto component = [&] { return middle + tolerance * (0.3 * *rc::gen::inRange(-6, 7)); };
    facet::PlaneTable table({0, 0, 0}, 1.0);
    for (int i = 0; i < 60; ++i) {
      const facet::Plane plane{{1.0, component(), middle}, component()};
      const std::vector<facet::Plane> before = table.planes();
      const auto coincides = [&](const facet::Plane& one) {
        const auto is_near = [&](double a, double b) { return b >= a - tolerance && b <= a + tolerance; };
        return is_near(plane.normal.x, one.normal.x) && is_near(plane.normal.y, one.normal.y) &&
               is_near(plane.normal.z, one.normal.z) && is_near(plane.offset, one.offset);
      };
      const auto expected = std::find_if(before.begin(), before.end(), coincides) - before.begin();
      RC_ASSERT(table.add(plane).plane == static_cast<std::uint32_t>(expected));
      RC_ASSERT(table.planes().size() == before.size() + (expected == std::ssize(before) ? 1 : 0));
    }
  }));
}

TEST_CASE("two touching solids share the plane between them under any rotation") {
  CHECK(rc::check([] {
    const glm::dmat4 place = turned(real(0, 6), {real(-9, 9), real(-9, 9), real(-9, 9)}, {1, 1, 1});
    model::Primitive low = primitive(model::Cube{{1, 2, 3}, false});
    model::Primitive high = primitive(model::Cube{{1, 2, 3}, false});
    low.transform = place;
    glm::dmat4 up(1.0);
    up[3] = {0, 0, 3, 1};
    high.transform = place * up;
    model::Tree tree;
    tree.primitives = {low, high};
    tree.nodes = {{true, model::Operator::unite, 0, {}},
                  {true, model::Operator::unite, 1, {}},
                  {false, model::Operator::unite, model::no_index, {0, 1}}};
    tree.root = 2;
    const facet::Geometry scene = facet::make_geometry(tree);
    RC_ASSERT(scene.planes.planes().size() == std::size_t{7});
  }));
}

TEST_CASE("the edges of a box are listed once each") {
  const facet::Geometry scene = facet::make_geometry(single(primitive(model::Cube{{1, 2, 3}, false})));
  CHECK(scene.solids[0].edges.size() == 12);
  CHECK(scene.solids[0].halfspaces.size() == 6);
}

TEST_CASE("the bounding box of a tree shrinks by intersection but not by difference") {
  model::Tree tree;
  tree.primitives = {primitive(model::Cube{{4, 4, 4}, false}), primitive(model::Cube{{2, 9, 9}, false})};
  tree.nodes = {{true, model::Operator::unite, 0, {}},
                {true, model::Operator::unite, 1, {}},
                {false, model::Operator::intersect, model::no_index, {0, 1}}};
  tree.root = 2;
  CHECK(facet::make_geometry(tree).box.high == glm::dvec3(2, 4, 4));
  tree.nodes[2].op = model::Operator::subtract;
  CHECK(facet::make_geometry(tree).box.high == glm::dvec3(4, 4, 4));
  tree.nodes[2].op = model::Operator::unite;
  CHECK(facet::make_geometry(tree).box.high == glm::dvec3(4, 9, 9));
}

TEST_CASE("a polygon within a tolerance of its circle has the minimum number of corners") {
  CHECK(rc::check([] {
    const double radius = real(1, 100);
    const double tolerance = radius * std::pow(10.0, -real(1, 6));
    const std::uint32_t count = facet::fragments_within(radius, tolerance);
    const auto sagitta = [&](std::uint32_t n) {
      return 2.0 * radius * std::pow(std::sin(std::numbers::pi / (2.0 * n)), 2);
    };
    RC_ASSERT(sagitta(count) <= tolerance * (1.0 + 1e-9));
    RC_ASSERT(count == 3U || sagitta(count - 1) > tolerance * (1.0 - 1e-9));
  }));
}

TEST_CASE("a faceted sphere lies within the sphere and within the tolerance") {
  CHECK(rc::check([] {
    model::Primitive one = primitive(model::Sphere{real(1, 20), {}});
    const double radius = std::get<model::Sphere>(one.shape).radius;
    const double tolerance = radius * std::pow(10.0, -real(1, 4));
    const facet::Solid solid = facet::make_solid(one, {tolerance, std::nullopt});
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 toward = glm::normalize(glm::dvec3(real(-9, 9), real(-9, 9), real(-9, 9)) + glm::dvec3(1e-7));
      double out = 1e300;
      for (const facet::Face& face : solid.faces) {
        const double along = glm::dot(face.plane.normal, toward);
        if (along > 0) out = std::min(out, -face.plane.offset / along);
      }
      RC_ASSERT(out <= radius * (1.0 + 1e-12));
      RC_ASSERT(out >= (radius - tolerance) * (1.0 - 1e-12));
    }
  }));
}

TEST_CASE("a faceted sphere has fewer half-spaces than an equally exact meridian mesh") {
  const double tolerance = 1e-3;
  const std::size_t covered =
      facet::make_solid(primitive(model::Sphere{1, {}}), {tolerance, std::nullopt}).faces.size();
  const double theta = std::acos(1.0 - tolerance);
  CHECK(static_cast<double>(covered) < 0.75 * std::numbers::pi * std::numbers::pi / (theta * theta));
}

TEST_CASE("a facet tolerance applies in model space for any transform of the solid") {
  model::Primitive one = primitive(model::Cylinder{1, 2, 2, false, {}});
  one.transform =
      glm::dmat4(glm::dvec4(10, 0, 0, 0), glm::dvec4(0, 3, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, 0, 0, 1));
  CHECK(facet::make_solid(one, {0.01, std::nullopt}).faces.size() == facet::fragments_within(2, 0.001) + 2);
}

TEST_CASE("a facet tolerance that is not positive is rejected") {
  for (const double tolerance : {0.0, -1.0, std::nan("")}) {
    CHECK_THROWS_AS(facet::make_geometry(single(primitive(model::Sphere{})), {tolerance, std::nullopt}), InputError);
  }
}
