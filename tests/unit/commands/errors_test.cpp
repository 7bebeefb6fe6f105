#include "host/commands/read.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::string fault_of(std::string_view text) {
  return testing::error_of([&] { commands::read_text(text, "a.jan"); });
}

}  // namespace

TEST_CASE("an invalid command in a .jan file is rejected with its position and a fix") {
  CHECK(fault_of("") == "a.jan: the file defines no solid; add a line such as `Object = block 1 2 3`");
  CHECK(fault_of("A = block 1 2") == "a.jan:1:14: expected a block's length along z, found the end of the line");
  CHECK(fault_of("A = block 1 2 0") == "a.jan:1:15: a block's length along z must be above 0");
  CHECK(fault_of("A = block 1 2 3 4") == "a.jan:1:17: expected the end of the line, found `4`");
  CHECK(fault_of("A = block 1 2 $") ==
        "a.jan:1:15: expected a name, a number or one of = + - * ( ), found `$`; a comment begins with #");
  CHECK(fault_of("A = block 1 2 1e999") ==
        "a.jan:1:15: number out of range: 1e999 exceeds the range of doubles; correct it");
  CHECK(fault_of("jump A 1") ==
        "a.jan:1:1: there is no command jump; a line is `NAME = ...`, or move, rotate, scale, colour, facets or "
        "tolerance with arguments");
  CHECK(fault_of("A = blok 1 2 3") == "a.jan:1:5: blok is not defined before this line; did you mean block?");
  CHECK(fault_of("A = B") == "a.jan:1:5: B is not defined before this line; write `B = ...` above");
  CHECK(fault_of("block = block 1 1 1") == "a.jan:1:1: block is a reserved word; choose another name");
  CHECK(fault_of("A = block 1 1 1\nmove A w 2") == "a.jan:2:8: expected x, y or z, found `w`");
  CHECK(fault_of("A = block 1 1 1\nmove A 1 2 3 4") == "a.jan:2:8: there are three axes; remove the extra numbers");
  CHECK(fault_of("A = block 1 1 1\nrotate A") ==
        "a.jan:2:9: expected x, y or z and degrees, found the end of the line");
  CHECK(fault_of("A = block 1 1 1\nscale A 0") == "a.jan:2:9: a scale of 0 removes the solid; use another number");
  CHECK(fault_of("A = block 1 1 1\ncolour A 1 2 0") ==
        "a.jan:2:10: a colour must be red, green and blue, each from 0 to 1");
  CHECK(fault_of("facets 2.5") == "a.jan:1:8: a circle must have 3 to 100000 facets");
  CHECK(fault_of("tolerance 0") == "a.jan:1:11: a tolerance in model units must be above 0");
}

TEST_CASE("an invalid expression in a .jan file is rejected with its position") {
  const std::string a = "A = block 1 1 1\n";
  CHECK(fault_of(a + "B = (A + A") == "a.jan:2:5: this `(` is not closed; add a `)`");
  CHECK(fault_of(a + "B = A + A)") == "a.jan:2:10: this `)` has no matching `(`; remove it");
  CHECK(fault_of(a + "B = A A") == "a.jan:2:7: expected +, -, * or the end of the line, found `A`");
  CHECK(fault_of(a + "B = A +") ==
        "a.jan:2:8: expected the name of a solid, or block, cylinder, cone, sphere, sweep, curve or patch, found the "
        "end of the line");
  CHECK(fault_of("c = curve points (0 0) (1 0)\nB = c") ==
        "a.jan:2:5: c is a curve, not a solid; make a solid with a sweep");
}

TEST_CASE("an invalid curve or sweep in a .jan file is rejected with its position") {
  CHECK(fault_of("c = curve degree 4 points (0)") == "a.jan:1:18: a degree must be 0 (constant), 1, 2 or 3");
  CHECK(
      fault_of("c = curve points (0 0) (1)") ==
      "a.jan:1:24: this point has a different number of coordinates (1) than those before it (2); use the same number");
  CHECK(fault_of("c = curve degree 3 points (0) (1)") ==
        "a.jan:1:11: an open curve of degree 3 needs at least 4 points, not 2");
  const std::string curves = "c = curve closed points (0 0) (1 0) (0 1)\nt = curve points (0 0 0) (0 0 5)\n";
  CHECK(fault_of(curves + "S = sweep contour c") ==
        "a.jan:3:1: a sweep needs a contour and a trajectory: S = sweep contour CURVE trajectory CURVE");
  CHECK(fault_of(curves + "S = sweep contour t trajectory t") ==
        "a.jan:3:19: the points of a contour must have 2 numbers, but those of t have 3");
  CHECK(fault_of(curves + "S = sweep contour c trajectory t scale t") ==
        "a.jan:3:40: the points of a scale must have 1 or 2 numbers, but those of t have 3");
  CHECK(fault_of(curves + "r = curve points (0 0 0) (0 0 5) (0 0 1)\nS = sweep contour c trajectory r") ==
        "a.jan:4:1: sweep: the trajectory reverses at the end of its segment 1; move that point");
  CHECK(fault_of("P = patch width 3 points (0 0 0)") == "a.jan:1:17: a row of a patch must have 4 to 10000 points");
}

TEST_CASE("a .jan file whose model grows exponentially is rejected in little time") {
  std::string text = "A = block 1 1 1\n";
  for (int i = 0; i < 40; ++i) text += "A = A + A\n";
  CHECK(fault_of(text) == "a.jan:1:1: more than 1000000 solids; split the model");
}