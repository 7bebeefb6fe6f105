#include "host/solids/evaluate.h"

#include "host/read/read.h"
#include "host/solids/hull.h"
#include "host/solids/minkowski.h"
#include "host/solids/projection.h"
#include "places.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using solids::Pieces;

namespace {

/// Tolerance for OpenSCAD's 6 digits and the bending that they cause.
constexpr double printed = 1e-4;

Pieces pieces_of(const std::string& text) { return solids::evaluate_pieces(read::read_csg_text(text, "m.csg")); }

std::string moved(const std::array<double, 3>& by, const std::string& text) {
  std::ostringstream out;
  out.precision(17);
  out << "multmatrix([[1,0,0," << by[0] << "],[0,1,0," << by[1] << "],[0,0,1," << by[2] << "],[0,0,0,1]]){" << text
      << "}";
  return out.str();
}

/// Rotated by degrees about an axis.
std::string turned(int axis, double degrees, const std::string& text) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  std::array<std::array<double, 3>, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto u = static_cast<std::size_t>((axis + 1) % 3);
  const auto v = static_cast<std::size_t>((axis + 2) % 3);
  rows[u][u] = rows[v][v] = c;
  rows[u][v] = -s;
  rows[v][u] = s;
  std::string matrix;
  for (const auto& row : rows) {
    matrix += "[";
    for (const double number : row) {
      std::array<char, 32> digits{};
      std::snprintf(digits.data(), digits.size(), "%.17g,", number);
      matrix += digits.data();
    }
    matrix += "0],";
  }
  return "multmatrix([" + matrix + "[0,0,0,1]]){" + text + "}";
}

std::string box(double x, double y, double z, bool center = false) {
  return "cube(size=[" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) +
         "],center=" + (center ? "true" : "false") + ");";
}

/// Checks that points clear of all planes are in a piece exactly if inside the mesh; returns the number inside.
int check_union(const solids::Mesh& mesh, const Pieces& pieces) {
  std::mt19937_64 random(11);
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point = testing::random_point(random, testing::extent_of(mesh.points));
    const auto expected = testing::is_inside(mesh, point);
    const auto count = testing::count_pieces_at(pieces, point, printed);
    if (!expected || !count) continue;
    REQUIRE((*count > 0) == *expected);
    inside += *expected ? 1 : 0;
  }
  return inside;
}

/// Outlines of the paths of OpenSCAD's SVG file, in which y points down.
std::vector<flat::Outline> load_svg(const std::string& name) {
  std::ifstream file(std::string(CSGSIM_SOURCE_DIR) + "/tests/models/solids/" + name + ".svg");
  std::vector<flat::Outline> outlines;
  std::string word;
  while (file >> word) {
    if (word == "M") outlines.emplace_back();
    if (word != "M" && word != "L") continue;
    double x = 0;
    double y = 0;
    char comma = 0;
    file >> x >> comma >> y;
    outlines.back().emplace_back(x, -y);
  }
  REQUIRE(!outlines.empty());
  return outlines;
}

double area_of(const flat::Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& a = outline[i];
    const glm::dvec2& b = outline[(i + 1) % outline.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

/// Whether a point is in an odd number of outlines.
bool is_in(const std::vector<flat::Outline>& outlines, const glm::dvec2& point) {
  bool inside = false;
  for (const flat::Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2& a = outline[i];
      const glm::dvec2& b = outline[(i + 1) % outline.size()];
      if ((a.y > point.y) == (b.y > point.y)) continue;
      if (point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside;
}

flat::Area projection(const std::string& text, bool cut) {
  const model::Tree tree = read::read_csg_text(text, "m.csg");
  return (cut ? solids::section(tree) : solids::shadow(tree)).area;
}

std::string shadow_model() {
  const std::string drilled = "difference(){" + box(10, 8, 6) + moved({2, 2, -1}, box(3, 3, 20)) + "}";
  // rotate([30, 20, 0]) rotates about x first.
  return turned(1, 20, turned(0, 30, drilled)) + moved({15, 0, 0}, "sphere($fn=16,$fa=12,$fs=2,r=3);");
}

void check_projection(const std::string& name, bool cut, int holes) {
  const std::vector<flat::Outline> expected = load_svg(name);
  const flat::Area area = projection(shadow_model(), cut);
  double expected_area = 0;
  for (const flat::Outline& outline : expected) expected_area += std::abs(area_of(outline));
  double sum = 0;
  int clockwise = 0;
  for (const flat::Outline& outline : area.outlines) {
    sum += area_of(outline);
    clockwise += area_of(outline) < 0 ? 1 : 0;
  }
  CHECK(area.outlines.size() == expected.size());
  CHECK(clockwise == holes);
  CHECK(sum == doctest::Approx(expected_area).epsilon(1e-5));
  std::mt19937_64 random(1);
  int inside = 0;
  int wrong = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 point = testing::random_point(random, {{0, -7, 0}, {18, 7, 0}});
    const bool is_inside = is_in(expected, glm::dvec2(point));
    inside += is_inside ? 1 : 0;
    wrong += is_in(area.outlines, glm::dvec2(point)) != is_inside ? 1 : 0;
  }
  CHECK(inside > 500);
  // A point closer to an outline than the precision of 6 digits may be on its other side.
  CHECK(wrong <= 1);
}

}  // namespace

TEST_CASE("an evaluated empty tree has no pieces and no vertices") {
  CHECK(solids::evaluate_pieces({}).empty());
  CHECK(solids::evaluate_vertices({}).empty());
}

TEST_CASE("the hull of differences and intersections equals OpenSCAD's") {
  const std::string text = "difference(){" + box(10, 8, 6) + moved({5, 4, 3}, box(10, 10, 10)) +
                           turned(1, 30, box(30, 30, 2, true)) + "} intersection(){" +
                           moved({0, 0, 8}, "sphere($fn=12,$fa=12,$fs=2,r=3);") + moved({-5, -5, 8}, box(9, 9, 9)) +
                           "}";
  const auto piece = solids::hull_piece(solids::evaluate_vertices(read::read_csg_text(text, "m.csg")));
  REQUIRE(piece);
  const solids::Mesh expected = testing::load_off("rest_hull");
  CHECK(testing::volume_of(piece->points, piece->faces) ==
        doctest::Approx(testing::volume_of(expected.points, expected.faces)).epsilon(1e-5));
  CHECK(check_union(expected, {*piece}) > 200);
}

TEST_CASE("a union's vertices include all vertices of both operands") {
  const auto vertices = solids::evaluate_vertices(
      read::read_csg_text("union(){cube(size=[1,2,3],center=false);sphere($fn=8,$fa=12,$fs=2,r=1);}", "m.csg"));
  CHECK(vertices.size() == 8 + 8 * 4);
}

TEST_CASE("the Minkowski sum of non-convex solids equals OpenSCAD's") {
  const Pieces first = pieces_of("difference(){" + box(10, 8, 3) + moved({4, 3, -1}, box(10, 10, 5)) + "}" +
                                 moved({14, 2, 1}, turned(1, 10, turned(0, 20, box(2, 2, 2)))));
  const Pieces second = pieces_of(box(2, 0.5, 1, true) + turned(2, 90, box(3, 0.5, 0.5, true)));
  const Pieces third = pieces_of("sphere($fn=8,$fa=12,$fs=2,r=0.5);");
  const std::array<Pieces, 4> solids{first, second, Pieces{}, third};
  CHECK(check_union(testing::load_off("rounded"), solids::minkowski(solids)) > 200);
}

TEST_CASE("a Minkowski sum of convex solids is one piece and adds the sizes of boxes") {
  const std::array<Pieces, 2> boxes{pieces_of(box(1, 2, 3)), pieces_of(moved({5, 0, 0}, box(4, 5, 6)))};
  const Pieces sum = solids::minkowski(boxes);
  REQUIRE(sum.size() == 1);
  CHECK(sum[0].points.size() == 8);
  CHECK(sum[0].faces.size() == 6);
  CHECK(testing::volume_of(sum) == doctest::Approx(5 * 7 * 9).epsilon(1e-12));
}

TEST_CASE("pieces of a Minkowski sum that lie inside others are dropped") {
  const std::array<Pieces, 2> solids{pieces_of(box(10, 10, 10) + moved({4, 4, 4}, box(1, 1, 1))),
                                     pieces_of(box(1, 1, 1))};
  CHECK(solids::minkowski(solids).size() == 1);
}

TEST_CASE("Minkowski sums with too many corners are rejected") {
  Pieces many(1);
  many[0].points.resize(5000);
  CHECK(testing::error_of([&] {
          solids::minkowski(std::array<Pieces, 2>{many, many});
        }) == "the Minkowski sum needs more than 20000000 sums of corners; use fewer facets ($fn)");
}

TEST_CASE("projections of solids equal OpenSCAD's with and without a cut") {
  check_projection("shadow", false, 0);
  check_projection("cut", true, 0);
}

TEST_CASE("a projected solid keeps its through holes and has no seams between pieces") {
  const std::string frame =
      "difference(){" + box(10, 8, 6) + moved({2, 2, -1}, box(3, 3, 20)) + moved({6, 3, -1}, box(1, 1, 20)) + "}";
  for (const bool cut : {false, true}) {
    const flat::Area area = projection(frame, cut);
    REQUIRE(area.outlines.size() == 3);
    double sum = 0;
    for (const flat::Outline& outline : area.outlines) {
      CHECK(outline.size() == 4);
      sum += area_of(outline);
    }
    CHECK(sum == doctest::Approx(80 - 9 - 1).epsilon(1e-9));
  }
}

TEST_CASE("a cut at z = 0 includes solids within 1e-6 of the plane and no others") {
  for (const double z : {0.0, -1.0, -0.5, 9e-7, -1 - 9e-7}) {
    const flat::Area area = projection(moved({0, 0, z}, box(1, 1, 1)), true);
    REQUIRE(area.outlines.size() == 1);
    CHECK(area_of(area.outlines[0]) == doctest::Approx(1).epsilon(1e-9));
  }
  for (const double z : {0.1, -1.1, 1e-6}) CHECK(projection(moved({0, 0, z}, box(1, 1, 1)), true).empty());
  CHECK(solids::section({}).area.empty());
  CHECK(solids::shadow({}).area.empty());
}

TEST_CASE("operands that end at z = 0 count in a cut as in OpenSCAD") {
  // Areas are those of OpenSCAD's meshes.
  const auto cut_area = [](const std::string& text) {
    double sum = 0;
    for (const flat::Outline& outline : projection(text, true).outlines) sum += area_of(outline);
    return sum;
  };
  const std::string block = moved({0, 0, -5}, box(10, 10, 10));
  const auto drilled = [&](double z) { return "difference(){" + block + moved({2, 2, z}, box(5, 5, 10)) + "}"; };
  CHECK(cut_area(drilled(0)) == doctest::Approx(75));
  CHECK(cut_area(drilled(-10)) == doctest::Approx(75));
  CHECK(cut_area(drilled(0.5)) == doctest::Approx(100));
  CHECK(cut_area(drilled(0) + moved({3, 3, -1}, box(1, 1, 1))) == doctest::Approx(76));
  const std::string below = moved({5, 5, -5}, box(10, 10, 5));
  CHECK(cut_area(box(10, 10, 5) + below) == doctest::Approx(175));
  CHECK(cut_area("intersection(){" + box(10, 10, 5) + below + "}") == doctest::Approx(25));
}
