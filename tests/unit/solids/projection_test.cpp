#include "host/solids/projection.h"

#include "host/flat/area.h"
#include "host/read/read.h"
#include "host/solids/plane_grid.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr double heights[] = {50, 1e3, 1e5, 1e8, 1e9, 1e10, 1e11, 9e11, 1e12 - 1024};

double area_of(const flat::Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i] - outline.front();
    const glm::dvec2 b = outline[(i + 1) % outline.size()] - outline.front();
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double area_of(const flat::Area& area) {
  double sum = 0;
  for (const flat::Outline& outline : area.outlines) sum += area_of(outline);
  return sum;
}

model::Tree tree_of(const std::string& text) { return read::read_csg_text(text, "m.csg"); }
double shadow_of(const std::string& text) { return area_of(solids::shadow(tree_of(text)).area); }
double section_of(const std::string& text) { return area_of(solids::section(tree_of(text)).area); }

std::string cylinder(double height, double r1, double r2, int sides = 32) {
  return fmt::format("cylinder($fn={},$fa=12,$fs=2,h={},r1={},r2={},center=false);", sides, height, r1, r2);
}
std::string cylinder(double height, double radius) { return cylinder(height, radius, radius); }
std::string box(double x, double y, double z) { return fmt::format("cube(size=[{},{},{}],center=true);", x, y, z); }
std::string moved(double x, double y, double z, const std::string& text) {
  return fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{{}}}", x, y, z, text);
}
/// Rotated about the y axis.
std::string tilted(double degrees, const std::string& text) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  return fmt::format("multmatrix([[{0:.17g},0,{1:.17g},0],[0,1,0,0],[{2:.17g},0,{0:.17g},0],[0,0,0,1]]){{{3}}}", c, s,
                     -s, text);
}

/// Area of a regular polygon in a circle.
double polygon(double radius, int sides = 32) {
  return 0.5 * sides * radius * radius * std::sin(2 * std::numbers::pi / sides);
}

doctest::Approx about(double area) { return doctest::Approx(area).epsilon(1e-9); }
/// An area cut with the tolerance of host/convex/clip.h.
doctest::Approx cut_about(double area) { return doctest::Approx(area).epsilon(2e-6); }

}  // namespace

TEST_CASE("a cone's shadow does not depend on the height of a cylinder next to it") {
  for (const double height : heights) {
    CAPTURE(height);
    CHECK(shadow_of(cylinder(20, 11.3333, 31.3333) + cylinder(height, 1.7325, 1.7325, 16)) == about(polygon(31.3333)));
    CHECK(shadow_of(cylinder(height, 31.3333, 11.3333) + cylinder(20, 1, 1)) == about(polygon(31.3333)));
    CHECK(shadow_of(moved(0, 0, -height / 2, cylinder(height, 2)) + moved(40, 0, 5, cylinder(1, 3))) ==
          about(polygon(2) + polygon(3)));
  }
}

TEST_CASE("the shadow of a drilled solid does not depend on the drill's length") {
  for (const double height : heights) {
    CAPTURE(height);
    const std::string drill = moved(0, 0, -height / 2, cylinder(height, 2));
    CHECK(shadow_of("difference(){" + cylinder(20, 30) + drill + "}") == cut_about(polygon(30) - polygon(2)));
    CHECK(shadow_of("intersection(){" + cylinder(20, 30) + drill + "}") == cut_about(polygon(2)));
    // The same drill tilted, at least 40 long: its middle is in the hole's middle.
    const std::string slanted = tilted(20, moved(0, 0, -height / 2, cylinder(height, 2)));
    const std::string short_drill = tilted(20, moved(0, 0, -25, cylinder(50, 2)));
    const std::string plate = box(40, 40, 2);
    CHECK(shadow_of("difference(){" + plate + slanted + "}") ==
          cut_about(shadow_of("difference(){" + plate + short_drill + "}")));
  }
}

TEST_CASE("the shadow of a tall solid minus small ones is that of the remainder") {
  for (const double height : heights) {
    CAPTURE(height);
    const std::string tall = cylinder(height, 30);
    // A tall tube on a disc and a tall cylinder on a ring remain.
    CHECK(shadow_of("difference(){" + tall + moved(0, 0, 10, cylinder(height, 25)) + "}") == cut_about(polygon(30)));
    CHECK(shadow_of("difference(){" + tall + moved(0, 0, -1, cylinder(11, 25)) + "}") == cut_about(polygon(30)));
    CHECK(shadow_of("difference(){" + tall + moved(0, 0, -1, cylinder(height + 2, 25)) + "}") ==
          cut_about(polygon(30) - polygon(25)));
    // A disc with a hole, and a tall cylinder next to the hole.
    CHECK(shadow_of("difference(){union(){" + cylinder(20, 30) + moved(15, 0, 0, cylinder(height, 4)) + "}" +
                    moved(-10, 0, -1, cylinder(22, 5)) + "}") == cut_about(polygon(30) - polygon(5)));
  }
}

TEST_CASE("a distant shadow does not make another one coarser") {
  for (const double x : {1e3, 1e6, 1e9, 1e12 - 10}) {
    CAPTURE(x);
    const solids::Projection made = solids::shadow(tree_of(cylinder(1, 10.1) + moved(x, 0, 0, box(4, 2, 1))));
    REQUIRE(made.area.outlines.size() == 2);
    const auto [small, large] = std::minmax({area_of(made.area.outlines[0]), area_of(made.area.outlines[1])});
    CHECK(large == about(polygon(10.1)));
    CHECK(small == doctest::Approx(8).epsilon(x * 1e-15));
    CHECK(made.coarse_size == 0);
  }
}

TEST_CASE("a cut at z = 0 does not depend on the height of the solid") {
  for (const double height : heights) {
    CAPTURE(height);
    const std::string tall = moved(0, 0, -height / 2, cylinder(height, 3));
    CHECK(section_of(tall + moved(20, 0, -1, cylinder(2, 5))) == about(polygon(3) + polygon(5)));
    CHECK(section_of("difference(){" + moved(0, 0, -1, cylinder(20, 30)) + tall + "}") ==
          about(polygon(30) - polygon(3)));
    const std::string wide = box(height, height, 2);
    CHECK(section_of("intersection(){" + tall + wide + "}") == about(polygon(3)));
    CHECK(section_of("difference(){" + tall + moved(height / 2, 0, 0, wide) + "}") == about(polygon(3) / 2));
    // The side of the wide one passes through the origin at an angle.
    CHECK(section_of("difference(){" + tall + tilted(30, moved(height / 2, 0, 0, wide)) + "}") ==
          cut_about(section_of("difference(){" + tall + tilted(30, moved(50, 0, 0, box(100, 100, 2))) + "}")));
    // A solid that ends a thousandth above the plane is not in the cut, even next to a tall one.
    CHECK(section_of(tall + moved(20, 0, 1e-3, cylinder(2, 5))) == about(polygon(3)));
    CHECK(section_of(tall + moved(20, 0, 1e-3, cylinder(height, 5))) == about(polygon(3)));
    // A tall cone, near its wide end.
    CHECK(section_of(moved(0, 0, -1, cylinder(height, 10, 5))) ==
          doctest::Approx(polygon(10 - 5 / height)).epsilon(1e-9));
  }
}

TEST_CASE("a projection rounded by more than a millionth of its size is reported") {
  const auto framed = [](double size) {
    return "difference(){" + box(size, size, 1) + box(size - 2, size - 2, 2) + "}" + box(2, 1, 1);
  };
  for (const double size : {1e3, 1e4}) CHECK(solids::shadow(tree_of(framed(size))).coarse_size == 0);
  const solids::Projection made = solids::shadow(tree_of(framed(1e9)));
  CHECK(made.coarse_size == doctest::Approx(2).epsilon(0.1));
  // 2^-36 to 2^-35 of the frame.
  CHECK(made.coarse_step >= 1e9 * 0x1p-36);
  CHECK(made.coarse_step <= 1e9 * 0x1p-35);
  CHECK(solids::section(tree_of(framed(1e9))).coarse_size == doctest::Approx(2).epsilon(0.1));
}

TEST_CASE("boxes of a projection are in one group unless axis-parallel lines separate them") {
  const auto flat_box = [](double x, double y, double width, double height) {
    return facet::Box{{x, y, 0}, {x + width, y + height, 0}};
  };
  const auto groups = [](const std::vector<facet::Box>& boxes) {
    std::vector<std::vector<std::uint32_t>> found = solids::group_boxes(boxes);
    for (auto& group : found) std::ranges::sort(group);
    std::ranges::sort(found);
    return found;
  };
  using Groups = std::vector<std::vector<std::uint32_t>>;
  CHECK(groups({}).empty());
  CHECK(groups({facet::Box{}}).empty());
  CHECK(groups({flat_box(0, 0, 1, 1), flat_box(1, 1, 1, 1)}) == Groups{{0, 1}});
  CHECK(groups({flat_box(0, 0, 1, 1), flat_box(1.5, 0, 1, 1)}) == Groups{{0}, {1}});
  CHECK(groups({flat_box(0, 0, 1, 1), flat_box(0, 1.5, 1, 1)}) == Groups{{0}, {1}});
  // There is a gap along y only after a split at the gap along x.
  CHECK(groups({flat_box(0, 0, 1, 1), flat_box(0, 2, 1, 1), flat_box(5, 0, 1, 4)}) == Groups{{0}, {1}, {2}});
  // A large box contains the first of two small ones.
  CHECK(groups({flat_box(0, 0, 9, 9), flat_box(1, 1, 1, 1), flat_box(20, 1, 1, 1)}) == Groups{{0, 1}, {2}});
}
