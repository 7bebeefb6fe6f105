#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Work limit equivalent to some seconds.
constexpr std::uint64_t ample_work = 1'000'000'000;

model::Tree read_within(const std::string& text, std::uint64_t limit = ample_work) {
  read::Options options;
  options.work = Work(limit);
  return read::read_csg_text(text, "m.csg", options);
}

std::string refusal(const std::string& text, std::uint64_t limit = ample_work) {
  return testing::error_of([&] { (void)read_within(text, limit); });
}

/// A polygon with sides across its whole extent that mostly cross each other.
std::string crossing_polygon(int corners) {
  std::string points;
  for (int i = 0; i < corners; ++i) {
    const double x = std::fmod(0.6180339887 * i, 1.0);
    const double y = std::fmod(0.7548776662 * i * (i % 7 + 1), 1.0);
    points += fmt::format("{}[{:.6f},{:.6f}]", i == 0 ? "" : ",", 1000 * x, 1000 * y);
  }
  return "polygon(points = [" + points + "], paths = undef, convexity = 1);";
}

std::string twisted(const std::string& arguments, const std::string& square) {
  return "linear_extrude(height = 24, center = false, convexity = 1, twist = 360, " + arguments +
         ") {\n  square(size = " + square + ", center = true);\n}\n";
}

}  // namespace

TEST_CASE("a thin area twisted to a point is cut in a bounded number of steps") {
  const model::Tree tree = read_within(twisted("slices = 30, scale = [0, 0]", "[12, 1e-7]"));
  CHECK(tree.primitives.size() < 1000);
}

TEST_CASE("an extrusion's slices beyond the piece limit are rejected before they are cut") {
  const std::string expected =
      "m.csg:1:1: linear_extrude(): linear_extrude() needs more than 100000 convex pieces; use fewer slices, "
      "or "
      "raise $fa or $fs";
  CHECK(refusal(twisted("slices = 100001, scale = [0.5, 0.5]", "[12, 5]"), 20'000) == expected);
  const std::string two =
      "square(size = [1, 1], center = false);\n"
      "multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { square(size = [1, 1], center = false); }";
  CHECK(
      refusal(
          "linear_extrude(height = 24, center = false, convexity = 1, twist = 360, slices = 60000, scale = [1, 1]) {" +
              two + "}",
          1'000'000) == expected);
}

TEST_CASE("areas with too many crossing sides are rejected before they are combined") {
  CHECK(refusal("square(size = [1, 1], center = false);\n" + crossing_polygon(3000), 100'000'000) ==
        "m.csg:2:1: polygon(): combining 2-D shapes needs more work than the limit of 100 million steps; use fewer or "
        "coarser parts in the model, or raise --limit");
  CHECK(read_within(crossing_polygon(100)).primitives.size() > 100);
}

TEST_CASE("the work limit of 2-D and 3-D operations is reported at their node") {
  const std::string areas = "circle($fn = 100, $fa = 12, $fs = 2, r = 2); square(size = [3, 3], center = true);";
  const std::string solids = "sphere($fn = 30, $fa = 12, $fs = 2, r = 2); cube(size = [3, 3, 3], center = true);";
  CHECK(refusal("union() {\n  difference() {" + areas + "}\n}", 10'000).find("m.csg:2:3: ") == 0);
  CHECK(refusal("group() {\n hull() {" + solids + "}}", 10'000).find("m.csg:2:2: hull(): ") == 0);
  CHECK(refusal("group() {\n minkowski(convexity = 0) {" + solids + "}}", 10'000).find("m.csg:2:2: minkowski(): ") ==
        0);
  CHECK(refusal("\n\nprojection(cut = true, convexity = 0) {" + solids + solids + "}", 11'000)
            .find("m.csg:3:1: projection(): ") == 0);
  CHECK(refusal(twisted("slices = 5, scale = [1, 1]", "[12, 5]"), 5'000).find("m.csg:1:1: linear_extrude(): ") == 0);
}

TEST_CASE("statements count as work and the error names the one beyond the limit") {
  const std::string cubes = "cube(1);\ncube(1);\ncube(1);";
  CHECK(refusal(cubes, 6'000) == "");
  CHECK(refusal(cubes, 5'999).find("m.csg:3:1: reading statements needs more work than the limit") == 0);
}

TEST_CASE("reading a model takes the same number of steps each time") {
  const std::string text = twisted("slices = 20, scale = [0.3, 0.4]", "[12, 5]") + crossing_polygon(50);
  const auto steps = [&] {
    read::Options options;
    options.work = Work(ample_work);
    (void)read::read_csg_text(text, "m.csg", options);
    return options.work.done();
  };
  const std::uint64_t first = steps();
  CHECK(first > 10'000);
  CHECK(steps() == first);
  CHECK_NOTHROW((void)read_within(text, first));
  CHECK(refusal(text, first - 1) != "");
}

TEST_CASE("a solid with coordinates beyond the drawable range is rejected with its place") {
  const auto faceted = [](const std::string& text) {
    return testing::error_of([&] { (void)facet::make_geometry(read::read_csg_text(text, "m.csg")); });
  };
  const std::string far =
      " the solid extends farther than 1e12 from the origin, where numbers are too coarse to draw it; move it closer, "
      "or "
      "scale "
      "it down";
  const auto moved = [](const char* by) {
    return fmt::format(
        "cube(size = [1, 1, 1], center = false);\nmultmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,{}],[0,0,0,1]]) "
        "{{\n  cylinder(h = 1, r1 = 2, r2 = 2, center = false, $fn = 8, $fa = 12, $fs = 2);\n}}",
        by);
  };
  CHECK(faceted(moved("1e308")) == "m.csg:3:3:" + far);
  CHECK(faceted(moved("-2e12")) == "m.csg:3:3:" + far);
  CHECK(faceted(moved("9e11")) == "");
  CHECK(faceted("cube(size = [1, 1e13, 1], center = true);") == "m.csg:1:1:" + far);
}

TEST_CASE("a mesh whose check alone exceeds the work limit is rejected beforehand") {
  const std::string tetrahedron =
      "polyhedron(points = [[0,0,0],[9,0,0],[0,9,0],[2,2,9],[2,2,3]], faces = "
      "[[0,2,1],[0,1,4],[1,3,4],[1,2,3],[0,4,2],[2,4,3]], convexity = 2);";
  CHECK(refusal(tetrahedron, 10'000).find("m.csg:1:1: checking a mesh of 6 faces needs more work than") == 0);
  CHECK(refusal(tetrahedron, 100'000) == "");
}
