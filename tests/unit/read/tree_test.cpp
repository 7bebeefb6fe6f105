#include "host/read/read.h"
#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/read/support.h"
#include "tests/unit/read/tree_invariants.h"

using namespace csgsim::model;
using namespace csgsim::read_test;
using csgsim::read_test::read;

TEST_CASE("groups and renders and the file itself are unions") {
  for (const char* node : {"group()", "union()", "render(convexity = 1)"}) {
    CHECK(outline(read(std::string("difference() { cube(9); ") + node + " { cube(1); sphere(r = 1); } }")) ==
          "difference(cube, union(cube, sphere))");
  }
  CHECK(outline(read("cube(1); sphere(r = 1); cube(2);")) == "union(cube, sphere, cube)");
}

TEST_CASE("a tree keeps the written structure except operators of one child or none") {
  CHECK(outline(read("union() { union() { cube(1); cube(1); } sphere(r = 1); }")) ==
        "union(union(cube, cube), sphere)");
  CHECK(outline(read("group() { intersection() { group() { sphere(r = 1); } } } group(); group() {}")) == "sphere");
}

TEST_CASE("children precede their parents and primitives are in tree order") {
  const Tree tree = read("difference() { cube(1); union() { sphere(r = 1); cube(2); } cylinder(1, 1, 1); }");
  CHECK(broken_invariant(tree) == "");
  CHECK(tree.root == tree.nodes.size() - 1);
  CHECK(outline(tree) == "difference(cube, union(sphere, cube), cylinder)");
}

TEST_CASE("an empty operand of an intersection empties it") {
  CHECK(outline(read("intersection() { cube(1); cube(0); }")) == "nothing");
  CHECK(outline(read("intersection() { group(); cube(1); } sphere(r = 1);")) == "sphere");
  CHECK(outline(read("intersection() { cube(1); intersection() { cube(0); cube(2); } cube(3); } sphere(r = 1);")) ==
        "sphere");
}

TEST_CASE("an empty first operand empties a difference while any other vanishes") {
  CHECK(outline(read("difference() { cube(0); cube(1); }")) == "nothing");
  CHECK(outline(read("difference() { group() {} cube(1); } sphere(r = 1);")) == "sphere");
  CHECK(outline(read("difference() { cube(1); cube(0); }")) == "cube");
  CHECK(outline(read("difference() { cube(1); cube(0); sphere(r = 1); }")) == "difference(cube, sphere)");
}

TEST_CASE("an empty operand of a union vanishes") {
  CHECK(outline(read("union() { cube(0); cube(1); sphere(r = -1); sphere(r = 1); }")) == "union(cube, sphere)");
}

TEST_CASE("an emptied operator leaves no nodes or primitives") {
  const Tree tree = read("cube(1); intersection() { union() { cube(1); cube(2); } cube(0); } sphere(r = 1);");
  CHECK(tree.primitives.size() == 2);
  CHECK(tree.nodes.size() == 3);
  CHECK(broken_invariant(tree) == "");
}

TEST_CASE("a model of empty solids is an empty tree") {
  const Tree tree = read("cube(0); %sphere(r = 1);");
  CHECK(tree.nodes.empty());
  CHECK(tree.primitives.empty());
  CHECK(tree.root == csgsim::model::no_index);
  CHECK(tree.file == "m.csg");
}

TEST_CASE("a .csg file without statements is rejected") {
  const char* message = "m.csg: no model found; export one from OpenSCAD";
  for (const char* text : {"", " \n", "// nothing\n", "/* nothing */;", "\xEF\xBB\xBF"})
    CHECK(error_of(text) == message);
}

TEST_CASE("the % modifier and the disable modifier drop any subtree") {
  CHECK(outline(read("%cube(1); *cube(2); sphere(r = 1);")) == "sphere");
  CHECK(outline(read("%group() { hull() { cube(1); } } * frob(x = 1) { cube(size = true); } sphere(r = 1);")) ==
        "sphere");
  CHECK(outline(read("difference() { %cube(1); sphere(r = 1); cube(2); }")) == "difference(sphere, cube)");
  CHECK(outline(read("intersection() { cube(1); %cube(0); *cube(0); cube(2); }")) == "intersection(cube, cube)");
  CHECK(outline(read("intersection() { cube(1); intersection() { %cube(1); } }")) == "nothing");
  CHECK(error_of("%cube(1;") == "m.csg:1:8: expected `,` or `)` in cube(...), found `;`");
}

TEST_CASE("the # modifier has no effect") {
  CHECK(outline(read("difference() { #cube(1); # sphere(r = 1); }")) == "difference(cube, sphere)");
  CHECK(outline(read("#%cube(1); sphere(r = 1);")) == "sphere");
}

TEST_CASE("the ! modifier makes its subtree the whole model and drops the rest") {
  const Tree tree = read(
      "hull(); color([1, 0, 0]) { multmatrix([[2,0,0,1],[0,2,0,1],[0,0,2,1],[0,0,0,1]]) {"
      "cube(1); !union() { sphere(r = 1); %cube(1); cube(2); } } } frob();");
  CHECK(outline(tree) == "union(sphere, cube)");
  CHECK(tree.primitives[0].transform == glm::dmat4(1));
  CHECK_FALSE(tree.primitives[0].colour);
  CHECK(broken_invariant(tree) == "");
}

TEST_CASE("the first ! counts even under % but not under a disable modifier") {
  CHECK(outline(read("!group() { cube(1); !sphere(r = 1); } !sphere(r = 1);")) == "union(cube, sphere)");
  CHECK(outline(read("*group() { !cube(1); } sphere(r = 1);")) == "sphere");
  CHECK(outline(read("*!cube(1); sphere(r = 1);")) == "sphere");
  CHECK(outline(read("%group() { !cube(1); } sphere(r = 1);")) == "cube");
  CHECK(outline(read("!%cube(1); sphere(r = 1);")) == "cube");
  CHECK(outline(read("/* ! */ cube(1);")) == "cube");
}

TEST_CASE("an error in a subtree with the ! modifier is reported") {
  CHECK(error_of("!group() { cub(1); }") == "m.csg:1:12: unknown node cub(); did you mean cube()?");
  CHECK(error_of("!cube(1); sphere(") ==
        "m.csg:1:18: expected `name = value`, a value or `)` in sphere(...), found the end of the file");
}

TEST_CASE("a node without half-spaces is rejected with a suggested replacement") {
  for (const char* node : {"fill", "glide", "roof", "subdiv", "import_stl"}) {
    CHECK(error_of("group() {\n  " + std::string(node) + "(file = \"x\", timestamp = 0);\n}") ==
          "m.csg:2:3: " + std::string(node) +
              "() cannot be turned into half-spaces; replace it by cube, sphere, cylinder, polyhedron or a boolean of "
              "them");
  }
}

TEST_CASE("an unknown node is rejected with the nearest known one") {
  CHECK(error_of("Sphere(r = 1);") == "m.csg:1:1: unknown node Sphere(); did you mean sphere()?");
  CHECK(error_of("diffrence() {}") == "m.csg:1:1: unknown node diffrence(); did you mean difference()?");
  CHECK(error_of("xyzzy();") ==
        "m.csg:1:1: unknown node xyzzy(); use one of group, union, render, difference, intersection, multmatrix, "
        "color, cube, sphere, cylinder, polyhedron, import, square, circle, polygon, text, offset, linear_extrude, "
        "rotate_extrude, hull, minkowski, resize, projection, surface");
  CHECK(error_of(std::string(100000, 'a') + "();").size() < 350);
}

TEST_CASE("children of a solid are rejected") {
  CHECK(outline(read("cube(1) {} sphere(r = 1) { %cube(1); }")) == "union(cube, sphere)");
  CHECK(error_of("cube(1) {\n sphere(r = 1); }") ==
        "m.csg:2:2: cube() cannot have children; put sphere() next to it, in a union() or difference()");
}

TEST_CASE("an operator of n operands counts as n - 1 and empty solids do not count") {
  const csgsim::model::Counts counts =
      count(read("difference() { cube(1); cube(2); union() { cube(1); cube(2); cube(3); } }"
                 "intersection() { cube(1); group() { cube(2); cube(0); } }"));
  CHECK(counts.primitives == 7);
  CHECK(counts.unions == 3);
  CHECK(counts.differences == 2);
  CHECK(counts.intersections == 1);
}

TEST_CASE("the test models have the counts of their README") {
  const auto counts_of = [](const std::string& name) {
    return count(csgsim::read::read_csg_file(CSGSIM_SOURCE_DIR "/tests/models/" + name + ".csg"));
  };
  CHECK(counts_of("thesis_fig_2_3").primitives == 3);
  CHECK(counts_of("thesis_fig_2_3").unions == 0);
  CHECK(counts_of("thesis_fig_2_3").differences == 1);
  CHECK(counts_of("thesis_fig_2_3").intersections == 1);
  CHECK(counts_of("carburettor").primitives == 22);
  CHECK(counts_of("carburettor").unions == 11);
  CHECK(counts_of("carburettor").differences == 10);
  CHECK(counts_of("carburettor").intersections == 0);
}