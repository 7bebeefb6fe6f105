#include "host/read/node_readers.h"
#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using namespace csgsim::model;
using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

template <typename Shape>
Shape only_shape(std::string_view text) {
  const csgsim::model::Tree tree = read(text);
  REQUIRE(tree.primitives.size() == 1);
  return std::get<Shape>(tree.primitives[0].shape);
}

}  // namespace

TEST_CASE("a cube takes a size per side or one for all and a centre flag") {
  const Cube box = only_shape<Cube>("cube(size = [1, 2.5, 3], center = true);");
  CHECK(box.size == glm::dvec3(1, 2.5, 3));
  CHECK(box.center);
  CHECK(only_shape<Cube>("cube(center = false, size = 4);").size == glm::dvec3(4));
  CHECK(only_shape<Cube>("cube([1, 2, 3], true);").center);
  CHECK(only_shape<Cube>("cube(center = true, [1, 2, 3]);").size == glm::dvec3(1, 2, 3));
  CHECK_FALSE(only_shape<Cube>("cube(2);").center);
}

TEST_CASE("a sphere takes a radius or a diameter") {
  const Sphere ball = only_shape<Sphere>("sphere($fn = 12, $fa = 5, $fs = 0.5, r = 3);");
  CHECK(ball.radius == 3);
  CHECK(ball.facets == FacetControl{12, 5, 0.5});
  CHECK(only_shape<Sphere>("sphere(3);").facets == FacetControl{0, 12, 2});
  CHECK(only_shape<Sphere>("sphere(d = 3);").radius == 1.5);
}

TEST_CASE("a cylinder takes its arguments in any order and form") {
  const Cylinder cone = only_shape<Cylinder>("cylinder($fn=7, $fa=12, $fs=2, h=5, r1=1, r2=0, center=true);");
  CHECK(cone.height == 5);
  CHECK(cone.r1 == 1);
  CHECK(cone.r2 == 0);
  CHECK(cone.center);
  CHECK(cone.facets == FacetControl{7, 12, 2});
  CHECK(only_shape<Cylinder>("cylinder(5, 1, 2, true);").r2 == 2);
  CHECK(only_shape<Cylinder>("cylinder(r = 3, h = 1);").r1 == 3);
  CHECK(only_shape<Cylinder>("cylinder(d = 3, h = 1);").r2 == 1.5);
  CHECK(only_shape<Cylinder>("cylinder(d1 = 3, r2 = 1, h = 1);").r1 == 1.5);
  CHECK(only_shape<Cylinder>("cylinder(r = 3, r2 = 1, h = 1);").r2 == 1);
  CHECK(only_shape<Cylinder>("cylinder(r = 3, r2 = 1, h = 1);").r1 == 3);
}

TEST_CASE("values of $fa and $fs below 0.01 are raised to 0.01") {
  CHECK(only_shape<Sphere>("sphere(r = 1, $fa = 0.001, $fs = -3);").facets == FacetControl{0, 0.01, 0.01});
  CHECK(only_shape<Sphere>("sphere(r = 1, $fn = -1, $fa = 0, $fs = 0);").facets == FacetControl{-1, 0.01, 0.01});
}

TEST_CASE("an undef argument counts as absent") {
  CHECK_FALSE(only_shape<Cube>("cube(size = 1, center = undef);").center);
  CHECK(error_of("cube(undef);") == "m.csg:1:1: cube() lacks its size; add size = [x, y, z]");
}

TEST_CASE("solids without a positive finite size are empty") {
  for (const char* text : {"cube(0);",
                           "cube(-1);",
                           "cube([1, 0, 1]);",
                           "cube([1, inf, 1]);",
                           "cube([nan, 1, 1]);",
                           "cube([1, 1, -nan]);",
                           "cube(-inf);",
                           "sphere(r = 0);",
                           "sphere(r = -1);",
                           "sphere(r = inf);",
                           "sphere(r = nan);",
                           "cylinder(h = 0, r = 1);",
                           "cylinder(h = -1, r = 1);",
                           "cylinder(h = inf, r = 1);",
                           "cylinder(h = nan, r = 1);",
                           "cylinder(h = 1, r1 = 0, r2 = 0);",
                           "cylinder(h = 1, r1 = -1, r2 = 1);",
                           "cylinder(h = 1, r1 = 1, r2 = -1);",
                           "cylinder(h = 1, r1 = inf, r2 = 1);",
                           "cylinder(h = 1, r1 = 1, r2 = nan);"}) {
    CAPTURE(text);
    CHECK(outline(read(text)) == "nothing");
  }
  CHECK(outline(read("cylinder(h = 1, r1 = 0, r2 = 1);")) == "cylinder");
  CHECK(outline(read("cylinder(h = 1, r1 = 1, r2 = -0);")) == "cylinder");
}

TEST_CASE("a missing argument is an error that says what to add") {
  CHECK(error_of(" cube(center = true);") == "m.csg:1:2: cube() lacks its size; add size = [x, y, z]");
  CHECK(error_of("sphere();") == "m.csg:1:1: sphere() lacks its r; add r = radius");
  CHECK(error_of("cylinder(r = 1);") == "m.csg:1:1: cylinder() lacks its h; add h = height");
  CHECK(error_of("cylinder(h = 1, r2 = 1);") == "m.csg:1:1: cylinder() lacks its r1; add r1 = radius");
  CHECK(error_of("cylinder(h = 1, r1 = 1);") == "m.csg:1:1: cylinder() lacks its r2; add r2 = radius");
}

TEST_CASE("an ill-typed argument is reported at its value") {
  CHECK(error_of("cube(size = [1, 2]);") == "m.csg:1:13: size of cube() must be a vector of 3 numbers");
  CHECK(error_of("cube(size = [1, 2, 3, 4]);") == "m.csg:1:13: size of cube() must be a vector of 3 numbers");
  CHECK(error_of("cube(size = [1, 2, [3]]);") == "m.csg:1:20: size of cube() must be a number");
  CHECK(error_of("cube(size = true);") == "m.csg:1:13: size of cube() must be a vector of 3 numbers");
  CHECK(error_of("cube(1, center = 1);") == "m.csg:1:18: center of cube() must be true or false");
  CHECK(error_of("sphere(r = \"1\");") == "m.csg:1:12: r of sphere() must be a number");
  CHECK(error_of("sphere(r = 1, $fn = [1]);") == "m.csg:1:21: $fn of sphere() must be a number");
}

TEST_CASE("an unknown argument is rejected with the nearest known one") {
  CHECK(error_of("cube(1, centre = true);") == "m.csg:1:9: cube() has no argument centre; did you mean center?");
  CHECK(error_of("cube(1, wobbliness = 1);") ==
        "m.csg:1:9: cube() has no argument wobbliness; its arguments are size, center");
  CHECK(error_of("group(x = 1);") == "m.csg:1:7: group() has no argument x; remove it");
}

TEST_CASE("repeated and surplus arguments are rejected") {
  CHECK(error_of("cube(1, size = 2);") == "m.csg:1:9: size is given twice in cube(...); remove one");
  CHECK(error_of("cube(1, convexity = 2, convexity = 2);") ==
        "m.csg:1:24: convexity is given twice in cube(...); remove one");
  CHECK(error_of("cube(1, true, 3);") ==
        "m.csg:1:15: cube() accepts at most 2 unnamed arguments; name this one or remove it");
  CHECK(error_of("group(1);") == "m.csg:1:7: group() accepts at most 0 unnamed arguments; name this one or remove it");
  CHECK(error_of("sphere(r = 1, d = 2);") == "m.csg:1:1: r and d are both given; remove one");
  CHECK(error_of("cylinder(h = 1, r = 1, r1 = 1, r2 = 1);") == "m.csg:1:1: r, r1 and r2 are all given; remove r");
}

TEST_CASE("arguments that OpenSCAD prints without effect are accepted") {
  CHECK(outline(read("render(convexity = 3) { cube(size = 1, $fn = 3, convexity = 2); }")) == "cube");
  CHECK(outline(read("render(3) { union(timestamp = 12) { sphere(r = 1, convexity = 1); } }")) == "sphere");
}

TEST_CASE("a primitive records its place in the model's file") {
  const csgsim::model::Tree tree = read("group() {\n\t#cube(1);\n}\n  sphere(r = 1);");
  REQUIRE(tree.primitives.size() == 2);
  CHECK(tree.primitives[0].location.line == 2);
  CHECK(tree.primitives[0].location.column == 3);
  CHECK(tree.primitives[1].location.line == 4);
  CHECK(tree.primitives[1].location.column == 3);
}