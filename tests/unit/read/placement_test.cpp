#include <glm/matrix.hpp>

#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using csgsim::model::Tree;
using namespace csgsim::read_test;
using csgsim::read_test::read;

namespace {

std::string placed(const std::string& matrix) { return "multmatrix(" + matrix + ") { cube(1); }"; }

glm::dmat4 transform_of(const std::string& text) { return read(text).primitives.at(0).transform; }

std::optional<glm::dvec3> colour_of(const std::string& text) { return read(text).primitives.at(0).colour; }

}  // namespace

TEST_CASE("a matrix is row-major in the file and column-major in the tree") {
  const glm::dmat4 matrix = transform_of(placed("[[1, 2, 3, 4], [0, 5, 6, 7], [0, 0, 8, 9], [0, 0, 0, 1]]"));
  CHECK(matrix[3] == glm::dvec4(4, 7, 9, 1));
  CHECK(matrix[1] == glm::dvec4(2, 5, 0, 0));
  CHECK(matrix[2] == glm::dvec4(3, 6, 8, 0));
}

TEST_CASE("matrices compose from the outside in") {
  const glm::dmat4 matrix = transform_of(
      "multmatrix([[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]) { multmatrix(m = "
      "[[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]])"
      "{ cube(1); } }");
  CHECK(matrix[3] == glm::dvec4(10, 12, 14, 1));
  CHECK(matrix[0] == glm::dvec4(2, 0, 0, 0));
}

TEST_CASE("a matrix is divided by its last entry") {
  CHECK(transform_of(placed("[[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,2]]"))[3] == glm::dvec4(2, 0, 0, 1));
  CHECK(transform_of(placed("[[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,-2]]"))[0] == glm::dvec4(-0.5, 0, 0, 0));
}

TEST_CASE("the last row and the last column are optional") {
  CHECK(transform_of(placed("[[1,0,0,4],[0,1,0,5],[0,0,1,6]]"))[3] == glm::dvec4(4, 5, 6, 1));
  CHECK(transform_of(placed("[[2,0,0],[0,1,0],[0,0,1]]"))[0] == glm::dvec4(2, 0, 0, 0));
}

TEST_CASE("a mirrored solid keeps its mirroring matrix") {
  CHECK(glm::determinant(transform_of(placed("[[-1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"))) == -1);
}

TEST_CASE("a matrix is divided by w and loses its perspective terms like in OpenSCAD") {
  CHECK(transform_of(placed("[[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0.5,1]]")) ==
        transform_of(placed("[[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,1]]")));
  CHECK(transform_of(placed("[[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0.5,0,2]]"))[3] == glm::dvec4(2, 0, 0, 1));
}

TEST_CASE("singular matrices flatten solids to nothing") {
  for (const char* matrix :
       {"[[0,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]",  // a zero row and column
        "[[1,0,0,0],[1,0,0,0],[0,0,1,0],[0,0,0,1]]",  // a zero column
        "[[1,1,0,0],[1,1,0,0],[0,0,1,0],[0,0,0,1]]",  // equal columns
        "[[1,2,3,0],[4,5,6,0],[7,8,9,0],[0,0,0,1]]", "[[0.1,0.3,0,0],[0.2,0.6,0,0],[0,0,1,0],[0,0,0,1]]"}) {
    CAPTURE(matrix);
    CHECK(outline(read(placed(matrix))) == "nothing");
  }
  CHECK(outline(read("intersection() { cube(1); " + placed("[[0,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]") + "}")) ==
        "nothing");
}

TEST_CASE("a solid that a matrix squeezes or shrinks is kept") {
  CHECK(outline(read(placed("[[1e-9,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"))) == "cube");
  CHECK(outline(read(placed("[[1e-9,0,0,0],[0,1e9,0,0],[0,0,1,0],[0,0,0,1]]"))) == "cube");
  CHECK(outline(read(placed("[[1e-200,0,0,0],[0,1e-200,0,0],[0,0,1e-200,0],[0,0,0,1]]"))) == "cube");
}

TEST_CASE("non-finite matrices empty their solids") {
  CHECK(outline(read(placed("[[inf,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"))) == "nothing");
  CHECK(outline(read(placed("[[1,0,0,nan],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"))) == "nothing");
  CHECK(outline(read(placed("[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,0]]"))) == "nothing");
  CHECK(outline(read("multmatrix([[1e200,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) {" +
                     placed("[[1e200,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]") + "}")) == "nothing");
}

TEST_CASE("a matrix without three or four rows of three or four numbers is rejected") {
  CHECK(error_of("multmatrix() { cube(1); }") ==
        "m.csg:1:1: multmatrix() lacks its m; add a 4x4 matrix by rows: [[1, 0, 0, x], [0, 1, 0, y], ...]");
  CHECK(error_of(placed("[[1,0,0,0]]")) == "m.csg:1:12: the matrix of multmatrix() must be a vector of 4 rows");
  CHECK(error_of(placed("[[1,0],[0,1,0,0],[0,0,1,0]]")) ==
        "m.csg:1:13: a row of the matrix of multmatrix() must be a vector of 3 or 4 numbers");
  CHECK(error_of(placed("[1,2,3,4]")) ==
        "m.csg:1:13: a row of the matrix of multmatrix() must be a vector of 3 or 4 numbers");
}

TEST_CASE("the outermost colour wins") {
  CHECK(colour_of("color([1, 0.5, 0, 1]) { color([0, 0, 1, 1]) { cube(1); } }") == glm::dvec3(1, 0.5, 0));
  CHECK(colour_of("group() { color(c = [0, 0.25, 1]) { group() { cube(1); } } }") == glm::dvec3(0, 0.25, 1));
  CHECK_FALSE(colour_of("cube(1);"));
}

TEST_CASE("a colour applies to its subtree only") {
  const Tree tree = read("color([1, 0, 0]) { cube(1); cube(2); } cube(3);");
  CHECK(tree.primitives[1].colour == glm::dvec3(1, 0, 0));
  CHECK_FALSE(tree.primitives[2].colour);
}

TEST_CASE("a colour with a negative component counts as no colour") {
  CHECK(colour_of("color([-1, -1, -1, 1]) { color([0, 0, 1, 1]) { cube(1); } }") == glm::dvec3(0, 0, 1));
  CHECK_FALSE(colour_of("color([-1, -1, -1, 1]) { cube(1); }"));
}

TEST_CASE("an alpha without a colour keeps the default colour") {
  const auto opacity_of = [](const std::string& text) { return read(text).primitives.at(0).opacity; };
  CHECK_FALSE(colour_of("color([-1, -1, -1, 0.5]) { cube(1); }"));
  CHECK(opacity_of("color([-1, -1, -1, 0.5]) { cube(1); }") == 0.5);
  CHECK(opacity_of("color([1, 0, 0, -1]) { cube(1); }") == 1);
  // The outermost complete colour of nested ones counts or, if none is complete, the innermost.
  const std::string within = "color([-1, -1, -1, 0.5]) { color([1, 0, 0, 1]) { cube(1); } }";
  CHECK(colour_of(within) == glm::dvec3(1, 0, 0));
  CHECK(opacity_of(within) == 1);
  CHECK(opacity_of("color([-1, -1, -1, 0.3]) { color([-1, -1, -1, 0.8]) { cube(1); } }") == 0.8);
  CHECK(opacity_of("color([1, 0, 0, 0.4]) { color([-1, -1, -1, 0.5]) { cube(1); } }") == 0.4);
}

TEST_CASE("components of a colour are clamped to 1 and alpha does not change the colour") {
  CHECK(colour_of("color([2, 0.5, inf, 0.1]) { cube(1); }") == glm::dvec3(1, 0.5, 1));
  CHECK(colour_of("color(alpha = 0.5, c = [0, 1, 0]) { cube(1); }") == glm::dvec3(0, 1, 0));
}

TEST_CASE("a colour that is not three or four numbers is rejected") {
  CHECK(error_of("color() { cube(1); }") == "m.csg:1:1: color() lacks its c; add [red, green, blue], each from 0 to 1");
  CHECK(error_of("color([1, 0]) { cube(1); }") ==
        "m.csg:1:7: the colour of color() must be a vector of 3 or 4 numbers");
  CHECK(error_of("color(1) { cube(1); }") == "m.csg:1:7: the colour of color() must be a vector of 3 or 4 numbers");
}
