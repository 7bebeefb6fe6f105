#include <unistd.h>

#include "host/read/read.h"
#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using csgsim::model::Tree;
using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

std::size_t piece_count(const std::string& text) {
  const Tree tree = read(text);
  CHECK(csgsim::model::count(tree).primitives == 1);
  return tree.primitives.size();
}

}  // namespace

TEST_CASE("an extrusion is one primitive and one piece if its area is convex") {
  CHECK(piece_count("linear_extrude(height = 2) { square([1, 1]); }") == 1);
  CHECK(piece_count("linear_extrude(height = 2) { polygon([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]); }") > 1);
  CHECK(piece_count("linear_extrude(height = 2) { union() { square([1, 1]); multmatrix([[1, 0, 0, 5], [0, 1, 0, 0], "
                    "[0, 0, 1, 0], [0, 0, 0, 1]]) { circle(r = 1); } } }") == 2);
}

TEST_CASE("a convex prism minus circles stays a difference and other holes make pieces") {
  const auto plate = [](const std::string& hole) {
    return read(
        "linear_extrude(height = 2) { difference() { square([20, 20]); multmatrix([[1, 0, 0, 10], "
        "[0, 1, 0, 10], [0, 0, 1, 0], [0, 0, 0, 1]]) { " +
        hole + " } } }");
  };
  const Tree holed = plate("circle(r = 5, $fn = 24);");
  CHECK(csgsim::model::count(holed).primitives == 1);
  CHECK(csgsim::model::count(holed).differences == 0);
  REQUIRE(holed.primitives.size() == 2);
  CHECK(holed.nodes[holed.root].op == csgsim::model::Operator::subtract);
  CHECK(std::get<csgsim::model::Polyhedron>(holed.primitives[1].shape).planes.size() == 26);
  const Tree pieces = plate("polygon([[0, 0], [5, 0], [5, 1], [1, 1], [1, 5], [0, 5]]);");
  CHECK(pieces.primitives.size() > 2);
  CHECK(pieces.nodes[pieces.root].op == csgsim::model::Operator::unite);
}

TEST_CASE("areas are combined before they are extruded") {
  CHECK(piece_count("linear_extrude(height = 2) { intersection() { square([2, 2]); circle(r = 1, $fn = 8); } }") == 1);
  CHECK(outline(read("linear_extrude(height = 2) { difference() { square([1, 1]); square([2, 2]); } }")) == "nothing");
  CHECK(outline(read("linear_extrude(height = 2) { difference() { group(); square([2, 2]); } }")) == "nothing");
  CHECK(outline(read("linear_extrude(height = 2) { intersection() { square([1, 1]); group(); } }")) == "nothing");
}

TEST_CASE("transforms apply outside and inside an extrusion") {
  const Tree tree = read(
      "multmatrix([[1, 0, 0, 10], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { linear_extrude(height = 2) { "
      "multmatrix([[3, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { square([1, 1]); } } }");
  REQUIRE(tree.primitives.size() == 1);
  CHECK(tree.primitives[0].transform[3].x == 10);
  double low = 100;
  double high = -100;
  for (const glm::dvec3& point : std::get<csgsim::model::Polyhedron>(tree.primitives[0].shape).points) {
    low = std::min(low, point.x);
    high = std::max(high, point.x);
  }
  CHECK(low == 1);
  CHECK(high == 4);
}

TEST_CASE("hulls and sums and extrusions take the outer colour") {
  const Tree tree = read("color([1, 0, 0, 1]) { hull() { color([0, 1, 0, 1]) { cube(1); } sphere(r = 1); } }");
  REQUIRE(tree.primitives.size() == 1);
  REQUIRE(tree.primitives[0].colour);
  CHECK(*tree.primitives[0].colour == glm::dvec3(1, 0, 0));
  CHECK(tree.primitives[0].node == "hull");
}

TEST_CASE("an imported file outside the model's folder is rejected") {
  // The model's folder is the current one.
  for (const char* file : {"/etc/passwd", "..", "a/../../", "/"}) {
    const std::string error = error_of("import(file = \"" + std::string(file) + "\");");
    CAPTURE(error);
    CHECK(error.find("is not in the model's folder; put the file there") != std::string::npos);
    CHECK(error.find("--imports-from FOLDER") != std::string::npos);
  }
}

TEST_CASE("a nonexistent imported file causes a warning and the rest is drawn") {
  for (const char* file :
       {"no/x.stl", "/no/such/folder/x.stl", "../no-such-x.stl", "a/../../no-such-x.off", "/etc/passwd/x.stl"}) {
    CAPTURE(file);
    const auto [tree, warnings] = read_with_warnings(fmt::format("import(file = \"{}\"); cube(5);", file));
    CHECK(outline(tree) == "cube");
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] == fmt::format("m.csg:1:1: warning: {} does not exist; import() is empty, as in OpenSCAD", file));
  }
  const auto [tree, warnings] = read_with_warnings("surface(file = \"/no/such/x.png\", center = false); cube(5);");
  CHECK(outline(tree) == "cube");
  CHECK(warnings.size() == 1);
}

TEST_CASE("invalid indices in a polygon's paths are dropped or truncated with a warning") {
  // Paths that OpenSCAD 2021.01 draws as a triangle of area 50.
  for (const char* paths : {"[[0,1,2,9]]", "[[0,1,2,-1]]", "[[0,1,2.9]]", "[[1,2,undef]]", "[[0,1,2],[7]]",
                            "[[0,1,2],7]", "[[0,1,2],undef]"}) {
    CAPTURE(paths);
    const auto [tree, warnings] = read_with_warnings(
        fmt::format("linear_extrude(height = 1) {{ polygon([[0,0],[10,0],[0,10]], paths = {}); }}", paths));
    REQUIRE(tree.primitives.size() == 1);
    CHECK(std::get<csgsim::model::Polyhedron>(tree.primitives[0].shape).points.size() == 6);
    CHECK(warnings.size() == 1);
  }
}

TEST_CASE("a file of another folder is imported if a given folder contains both") {
  namespace fs = std::filesystem;
  const fs::path outer = fs::temp_directory_path() / fmt::format("csgsim-read-{}-imports", ::getpid());
  fs::create_directories(outer / "models");
  fs::create_directories(outer / "parts");
  std::ofstream(outer / "parts" / "plate.svg") << "<svg><rect width=\"10\" height=\"10\"/></svg>";
  const std::string name = (outer / "models" / "model.csg").string();
  for (const std::string& file : {std::string("../parts/plate.svg"), (outer / "parts" / "plate.svg").string()}) {
    const std::string text = "linear_extrude(height = 1) { import(file = \"" + file + "\"); }";
    CHECK_THROWS_AS(csgsim::read::read_csg_text(text, name), csgsim::InputError);
    CHECK_THROWS_AS(csgsim::read::read_csg_text(text, name, {false, outer / "models" / "."}), csgsim::InputError);
    for (const fs::path& from : {outer, outer / "", outer / "models" / ".."}) {
      const Tree tree = csgsim::read::read_csg_text(text, name, {false, from});
      CHECK(tree.primitives.size() == 1);
      CHECK(tree.imports == std::vector{outer / "parts" / "plate.svg"});
    }
  }
  fs::remove_all(outer);
}

TEST_CASE("a flat shape alone is a plate about z = 0 but next to a solid it is dropped") {
  CHECK(outline(read("square([2, 3]);")) == "polyhedron");
  CHECK(outline(read("cube(1); square([2, 3]);")) == "cube");
  CHECK(outline(read("difference() { cube(1); square([2, 3]); }")) == "cube");
}

TEST_CASE("solids are dropped where flat shapes are expected and vice versa") {
  CHECK(piece_count("linear_extrude(height = 2) { cube(1); square([1, 1]); }") == 1);
  CHECK(read("linear_extrude(height = 2) { cube(1); }").primitives.empty());
  CHECK(read("projection() { square([1, 1]); }").primitives.empty());
  CHECK(piece_count("linear_extrude(height = 1) { projection() { square([5, 1]); cube([2, 3, 4]); } }") == 1);
}

TEST_CASE("an empty file name yields an empty shape") {
  CHECK(read("import(file = \"\");").primitives.empty());
  CHECK(read("surface(file = \"\", center = false, invert = false);").primitives.empty());
  CHECK(error_of("import();").find("add file") != std::string::npos);
}

TEST_CASE("text with explicit default alignment equals text without alignment") {
  const std::string explicit_default = "text(text = \"a\", halign = \"default\", valign = \"default\");";
  CHECK(csgsim::read_test::dump(read(explicit_default)) == csgsim::read_test::dump(read("text(text = \"a\");")));
}

TEST_CASE("strings of a .csg file have the values that OpenSCAD wrote") {
  const std::string file = "../a\\\\b.stl";
  CHECK(read_with_warnings("import(file = \"" + file + "\");").warnings.at(0).find("a\\") != std::string::npos);
}
