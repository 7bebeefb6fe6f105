#include "host/commands/read.h"

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/read/tree_invariants.h"

using namespace csgsim;

namespace {

model::Tree tree_of(std::string_view text) {
  model::Tree tree = commands::read_text(text, "test.jan");
  CHECK(read_test::broken_invariant(tree) == "");
  return tree;
}

/// The tree as text: primitives as numbers, operators in parentheses.
std::string shown(const model::Tree& tree) {
  std::vector<std::string> texts;
  for (const model::Node& node : tree.nodes) {
    if (node.is_leaf) {
      texts.push_back(std::to_string(node.primitive));
      continue;
    }
    constexpr std::string_view signs = "+-*";
    std::string text = "(";
    for (const std::uint32_t child : node.children) {
      if (text.size() > 1) text += signs[static_cast<std::size_t>(node.op)];
      text += texts[child];
    }
    texts.push_back(text + ")");
  }
  return texts.at(tree.root);
}

glm::dvec3 moved(const model::Tree& tree, std::size_t primitive, const glm::dvec4& point) {
  return {tree.primitives[primitive].transform * point};
}

bool near(const glm::dvec3& one, const glm::dvec3& other) { return glm::distance(one, other) < 1e-12; }

constexpr std::string_view three = "A = block 1 2 3\nB = sphere 2\nC = cylinder 1 5\n";

std::string of_three(std::string_view expression) {
  return shown(tree_of(std::string(three) + "Object = " + std::string(expression) + "\n"));
}

std::string text_of(const std::string& model) {
  std::ifstream file(std::string(CSGSIM_SOURCE_DIR) + "/tests/models/" + model);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("intersection in a .jan file binds tighter than union and difference") {
  CHECK(of_three("A - (B * C)") == "(0-(1*2))");
  CHECK(of_three("A - B * C") == "(0-(1*2))");
  CHECK(of_three("A * B - C") == "((0*1)-2)");
  CHECK(of_three("A - B + C") == "((0-1)+2)");
  CHECK(of_three("A - (B + C)") == "(0-(1+2))");
  CHECK(of_three("((A) + ((B)))*C") == "((0+1)*2)");
  CHECK(of_three("C-B") == "(0-1)");
}

TEST_CASE("primitives of a .jan file have their stated sizes") {
  const model::Tree tree = tree_of("facets 30\nA = block 1 2 3\nB = cone 4 5\nC = cone 4 5 1.5\nD = A + B + C\n");
  CHECK(std::get<model::Cube>(tree.primitives[0].shape).size == glm::dvec3(1, 2, 3));
  const auto& cone = std::get<model::Cylinder>(tree.primitives[1].shape);
  CHECK(cone.r1 == 4);
  CHECK(cone.r2 == 0);
  CHECK(cone.height == 5);
  CHECK(cone.facets.fn == 30);
  CHECK(std::get<model::Cylinder>(tree.primitives[2].shape).r2 == 1.5);
}

TEST_CASE("a command on a name in a .jan file affects only later uses of the name") {
  const model::Tree tree = tree_of("A = block 1 1 1\nmove A 5\nB = A\nmove A y 2 z -1\nObject = A + B\n");
  CHECK(near(moved(tree, 0, {0, 0, 0, 1}), {5, 2, -1}));
  CHECK(near(moved(tree, 1, {0, 0, 0, 1}), {5, 0, 0}));
}

TEST_CASE("commands rotate about the axes of the model and scale about its origin") {
  const model::Tree tree = tree_of("A = block 1 2 3\nmove A 10 0 0\nrotate A z 90 x 90\nscale A 2\nscale A y 3\n");
  // (11, 2, 3) -> (-2, 11, 3) -> (-2, -3, 11) -> (-4, -18, 22)
  CHECK(near(moved(tree, 0, {1, 2, 3, 1}), {-4, -18, 22}));
}

TEST_CASE("a primitive has the colour of the last colour command on a solid with it") {
  const model::Tree tree =
      tree_of("A = block 1 1 1\ncolour A 1 0 0\nB = sphere 1\nC = A + B\nE = C + A\ncolour C 0 0 1\nObject = C + E\n");
  CHECK(*tree.primitives[0].colour == glm::dvec3(0, 0, 1));
  CHECK(*tree.primitives[1].colour == glm::dvec3(0, 0, 1));
  CHECK(*tree.primitives[2].colour == glm::dvec3(1, 0, 0));
  CHECK(!tree.primitives[3].colour);
}

TEST_CASE("the solid named Object is drawn and the last solid if there is none") {
  CHECK(std::holds_alternative<model::Sphere>(tree_of("Object = sphere 1\nB = block 1 1 1\n").primitives[0].shape));
  CHECK(std::holds_alternative<model::Cube>(tree_of("A = sphere 1\nB = block 1 1 1\n").primitives[0].shape));
  const model::Tree moved_last = tree_of("A = sphere 1\nB = block 1 1 1\nmove A 9\nmove B 7\n");
  CHECK(near(moved(moved_last, 0, {0, 0, 0, 1}), {7, 0, 0}));
}

TEST_CASE("a .jan file may have comments and continuation lines and any line ending") {
  CHECK(shown(tree_of("# one\r\n\r\n  A = block 1 \\\r\n 2 3 # two\r\nB=A+A # \\\n")) == "(0+1)");
}

TEST_CASE("the location of a primitive is the line of the .jan file that creates it") {
  const model::Tree tree = tree_of("A = block 1 1 1\n\n  B = sphere 1\nObject = A + B");
  CHECK(tree.primitives[1].location.line == 3);
  CHECK(tree.primitives[1].location.column == 3);
}

TEST_CASE("thesis fig. 2.3 as a .jan file equals its .csg file to six digits") {
  const facet::Geometry written = facet::make_geometry(tree_of(text_of("thesis_fig_2_3.jan")));
  const facet::Geometry exported = facet::make_geometry(read::read_csg_text(text_of("thesis_fig_2_3.csg"), "fig.csg"));
  CHECK(written.halfspaces() == exported.halfspaces());
  CHECK(near(written.box.low, exported.box.low));
  const model::Tree tree = tree_of(text_of("thesis_fig_2_3.jan"));
  const model::Tree other = read::read_csg_text(text_of("thesis_fig_2_3.csg"), "fig.csg");
  CHECK(shown(tree) == shown(other));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(*tree.primitives[i].colour == *other.primitives[i].colour);
    CHECK(glm::distance(moved(tree, i, {1, 2, 3, 1}), moved(other, i, {1, 2, 3, 1})) < 1e-5);
  }
}

TEST_CASE("a sweep is one primitive in convex pieces and combines with others") {
  const model::Tree tree = tree_of(
      "square = curve closed points (-1 -1) (1 -1) (1 1) (-1 1)\n"
      "frame = curve closed points (10 0 0) (0 0 0) (0 0 8) (10 0 8)\n"
      "S = sweep contour square trajectory frame\n"
      "B = sphere 1\n"
      "Object = S - B\n"
      "move Object 100\n");
  CHECK(model::count(tree).primitives == 2);
  CHECK(tree.primitives.size() == 5);
  CHECK(tree.primitives[0].node == "sweep");
  CHECK(!tree.primitives[0].continues);
  CHECK(tree.primitives[3].continues);
  CHECK(tree.primitives[0].transform[3][0] == 100);
  CHECK(shown(tree) == "((0+1+2+3)-4)");
}

TEST_CASE("a .jan file lists its sweeps and patches in order and the last one of a name") {
  const std::vector<commands::NamedSurface> surfaces = commands::read_surfaces(
      "c = curve closed degree 2 points (-1 -1) (1 -1) (1 1) (-1 1)\n"
      "t = curve points (0 0 0) (0 0 9)\n"
      "r = curve points (0) (90)\n"
      "e = curve degree 2 points (1 2) (3 4) (1 1)\n"
      "tolerance 0.25\n"
      "A = sweep contour c trajectory t\n"
      "P = patch width 4 points (0 0 0) (1 0 0) (2 0 0) (3 0 0) (0 1 0) (1 1 0) (2 1 0) (3 1 0) \\\n"
      "  (0 2 0) (1 2 0) (2 2 0) (3 2 0) (0 3 0) (1 3 0) (2 3 0) (3 3 7)\n"
      "A = sweep contour c trajectory t rotation r scale e tolerance 0.5\n",
      "test.jan");
  REQUIRE(surfaces.size() == 2);
  CHECK(surfaces[0].name == "P");
  CHECK(!surfaces[0].is_sweep);
  CHECK(surfaces[0].tolerance == 0.25);
  CHECK(surfaces[0].net.rows[3][3] == glm::dvec3(3, 3, 7));
  CHECK(surfaces[1].name == "A");
  CHECK(surfaces[1].tolerance == 0.5);
  CHECK(surfaces[1].sweep.rotation.points[1].x == 90);
  CHECK(surfaces[1].sweep.scale.points[1] == glm::dvec3(3, 4, 0));
  CHECK(surfaces[1].sweep.contour.degree == 2);
}
