#include "host/read/read.h"
#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

/// Returns whether a text yields `nothing`, `flat` or `solid`; extruding it tells flat shapes from solids.
std::string kind(const std::string& text) {
  const bool is_seen = outline(read(text)) != "nothing";
  const bool is_flat = outline(read("linear_extrude(height = 1) { " + text + " }")) != "nothing";
  CHECK((is_seen || !is_flat));
  return is_flat ? "flat" : is_seen ? "solid" : "nothing";
}

}  // namespace

// The expected kinds are those of OpenSCAD 2021.01; the corpus has many of these models as mixed_dimensions.

TEST_CASE("the first operand that is 2-D or 3-D decides which kind of operand counts") {
  CHECK(kind("union() { cube(4); square(4); }") == "solid");
  CHECK(kind("union() { square(4); cube(4); }") == "flat");
  CHECK(kind("hull() { square(4); cube(4); }") == "flat");
  CHECK(kind("hull() { cube(4); square(4); }") == "solid");
  CHECK(kind("resize(newsize = [5, 5, 5]) { square(4); cube(4); }") == "flat");
  CHECK(kind("union() { group() { } square(4); cube(4); }") == "flat");
}

TEST_CASE("a 2-D operand among solids is empty and so is a 3-D one among flat shapes") {
  CHECK(kind("intersection() { cube(6); square(4); }") == "nothing");
  CHECK(kind("intersection() { square(4); cube(6); }") == "nothing");
  CHECK(kind("intersection() { cube(6); cube(5); square(4); }") == "nothing");
  CHECK(kind("difference() { cube(6); square(4); }") == "solid");
  CHECK(kind("difference() { square(6); cube(4); }") == "flat");
  CHECK(kind("minkowski() { cube(3); square(3); }") == "solid");
  CHECK(kind("minkowski() { square(3); cube(3); }") == "nothing");
}

TEST_CASE("an empty shape is 2-D or 3-D and can decide which operands count") {
  CHECK(kind("union() { square(0); cube(4); }") == "nothing");
  CHECK(kind("union() { circle(r = 0); cube(4); }") == "nothing");
  CHECK(kind("union() { cube(0); square(4); }") == "nothing");
  CHECK(kind("union() { sphere(r = 0); square(4); }") == "nothing");
  CHECK(kind("union() { polyhedron(points = undef, faces = undef); square(4); }") == "nothing");
  CHECK(kind("union() { text(text = \"\"); cube(4); }") == "nothing");
  CHECK(kind("union() { cube(4); square(0); }") == "solid");
  CHECK(kind("difference() { circle(r = 0); cube(4); }") == "nothing");
}

TEST_CASE("a union of one empty flat shape or several empty solids is neither 2-D nor 3-D") {
  CHECK(kind("union() { union() { square(0); } cube(4); }") == "solid");
  CHECK(kind("union() { union() { square(0); square(0); } cube(4); }") == "nothing");
  CHECK(kind("union() { union() { cube(0); } square(4); }") == "nothing");
  CHECK(kind("union() { union() { cube(0); cube(0); } square(4); }") == "flat");
  CHECK(kind("union() { resize(newsize = [4, 4, 4]) { square(0); } cube(4); }") == "solid");
  CHECK(kind("union() { offset(r = 1) { square(0); } cube(4); }") == "solid");
}

TEST_CASE("a Boolean of solids and an operand that is neither 2-D nor 3-D is neither") {
  CHECK(kind("union() { intersection() { cube(4); square(4); } square(5); }") == "flat");
  CHECK(kind("union() { intersection() { square(4); cube(4); } cube(5); }") == "nothing");
  CHECK(kind("union() { intersection() { cube(3); cube(0); } square(4); }") == "flat");
  CHECK(kind("union() { intersection() { cube(0); cube(3); } square(4); }") == "nothing");
  CHECK(kind("union() { difference() { group() { } cube(3); } square(4); }") == "flat");
}

TEST_CASE("empty extrusions and projections and hulls decide the kind as in OpenSCAD") {
  CHECK(kind("union() { linear_extrude(height = 3) { square(0); } square(4); }") == "flat");
  CHECK(kind("union() { linear_extrude(height = 3) { square(0); square(0); } square(4); }") == "nothing");
  CHECK(kind("union() { rotate_extrude(angle = 0) { square(3); } square(4); }") == "flat");
  CHECK(kind("union() { projection() { square(3); } cube(4); }") == "solid");
  CHECK(kind("union() { hull() { cube(0); } square(4); }") == "flat");
  CHECK(kind("union() { hull() { square(0); } cube(4); }") == "nothing");
}

TEST_CASE("an extrusion of a file ignores its children") {
  const std::string name = CSGSIM_SOURCE_DIR "/tests/corpus/extrude_dxf_file.csg";
  for (const char* node : {"linear_extrude(file = \"data/shapes.dxf\", layer = \"plate\", height = 3",
                           "rotate_extrude(file = \"data/shapes.dxf\", layer = \"plate\""}) {
    CAPTURE(node);
    const auto made = [&](const std::string& children) {
      return dump(csgsim::read::read_csg_text(std::string(node) + ") { " + children + " }", name));
    };
    CHECK(made("") != "");
    CHECK(made("square(50);") == made(""));
  }
}

TEST_CASE("a polygon with a point that is not two finite numbers is empty and flat") {
  for (const char* point : {"undef", "3", "\"a\"", "[5]", "[5, 2, 3]", "[1, undef]", "[1, inf]", "[nan, 1]", "[]"}) {
    CAPTURE(point);
    const std::string polygon =
        std::string("polygon(points = [[0, 0], [9, 0], [9, 9], ") + point + "], paths = undef);";
    CHECK(kind(polygon) == "nothing");
    CHECK(kind(polygon + " cube(4);") == "nothing");
  }
}

TEST_CASE("a flat Minkowski sum of several operands is empty unless two are not empty") {
  CHECK(kind("minkowski() { circle(r = 0); square(4); }") == "nothing");
  CHECK(kind("minkowski() { square(4); circle(r = 0); }") == "nothing");
  CHECK(kind("minkowski() { group() { } square(4); }") == "nothing");
  CHECK(kind("minkowski() { square(4); circle(r = 0); square(1); }") == "flat");
  CHECK(kind("minkowski() { square(4); }") == "flat");
  CHECK(kind("minkowski() { cube(0); cube(4); }") == "solid");
}
