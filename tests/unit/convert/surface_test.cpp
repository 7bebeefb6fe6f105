#include "sim/software/convert/surface.h"

#include "host/model/tree.h"
#include "host/read/read.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/outlines.h"
#include "sim/software/convert/side.h"
#include "sim/software/convert/triangulate.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"

using namespace csgsim;
namespace convert = software::convert;
using convert::Measures;
using convert::Outline;
using convert::Outlines;
using convert::Side;
using convert::Surface;
using convert::Triangle;

namespace {

/// A tetrahedron with edges of 1, 2 and 3 along the axes.
Surface tetrahedron(const glm::dvec3& at = glm::dvec3(0)) {
  return {{at, at + glm::dvec3(1, 0, 0), at + glm::dvec3(0, 2, 0), at + glm::dvec3(0, 0, 3)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
          {0, 1, 2, 3}};
}

Surface together(const Surface& one, const Surface& other) {
  Surface both = one;
  const auto first = static_cast<std::uint32_t>(one.points.size());
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& triangle : other.triangles)
    both.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  for (std::size_t i = 0; i < other.triangles.size(); ++i) both.outlines.push_back(4);
  return both;
}

std::vector<Side> loop_of(const std::vector<std::uint32_t>& corners) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) sides.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return sides;
}

/// Checks the triangles of outlines for orientation and order.
std::string out_of_outlines(const Surface& surface, const Outlines& outlines) {
  if (surface.outlines.size() != surface.triangles.size()) return "outline count differs from triangle count";
  if (!std::ranges::is_sorted(surface.outlines)) return "outlines are not in ascending order";
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& [a, b, c] = surface.triangles[i];
    const glm::dvec3 normal = glm::cross(surface.points[b] - surface.points[a], surface.points[c] - surface.points[a]);
    if (glm::dot(normal, outlines.outlines.at(surface.outlines[i]).outward) < 0.9 * glm::length(normal))
      return std::to_string(i) + " faces another way";
  }
  return "";
}

}  // namespace

TEST_CASE("measures of one and two tetrahedra match a hand calculation") {
  // The volume is 1 * 2 * 3 / 6; the area is that of three right triangles and one with the normal (6, 3, 2) of length
  // 7.
  for (const glm::dvec3& at : {glm::dvec3(0), glm::dvec3(1024, -2048, 512)}) {
    const Measures one = convert::measure(tetrahedron(at));
    CHECK(one.volume == doctest::Approx(1).epsilon(1e-14));
    CHECK(one.area == doctest::Approx((1 * 2 + 1 * 3 + 2 * 3 + 7) / 2.0).epsilon(1e-14));
    CHECK(one.euler == 2);
    CHECK(one.shells == 1);
    CHECK(one.genus() == 0);
  }
  const Measures two = convert::measure(together(tetrahedron(), tetrahedron({5, 5, 5})));
  CHECK(two.volume == doctest::Approx(2).epsilon(1e-14));
  CHECK(two.area == doctest::Approx(18).epsilon(1e-14));
  CHECK(two.euler == 4);
  CHECK(two.shells == 2);
  CHECK(two.genus() == 0);
  // Inside out, the volume is negative.
  Surface inside_out = tetrahedron();
  for (Triangle& triangle : inside_out.triangles) std::swap(triangle[1], triangle[2]);
  CHECK(convert::measure(inside_out).volume == doctest::Approx(-1).epsilon(1e-14));
  CHECK(Measures{.euler = 0, .shells = 1}.genus() == 1);
  CHECK(Measures{.euler = -8, .shells = 1}.genus() == 5);
  CHECK(Measures{.euler = 2, .shells = 2}.genus() == 1);
}

TEST_CASE("the volume error is projected area times half a unit of the coordinate") {
  constexpr double half_unit = 0x1p-53;
  // A block at the origin has three faces away from 0, each contributing its volume of 1 * 2 * 3.
  CHECK(convert::measure(testing::converted("cube([1,2,3]);")).volume_error == doctest::Approx(18 * half_unit));
  // The same block at 10 along x and -20 along y: (10 + 11) 6 + (20 + 18) 3 + 3 2.
  CHECK(convert::measure(testing::converted("multmatrix([[1,0,0,10],[0,1,0,-20],[0,0,1,0],[0,0,0,1]]){cube([1,2,3]);}"))
            .volume_error == doctest::Approx((21 * 6 + 38 * 3 + 6) * half_unit));
  // The oblique face has the same projection along each axis as the face at 0.
  CHECK(convert::measure(tetrahedron()).volume_error == doctest::Approx((3 * 1 + 1.5 * 2 + 1 * 3) * half_unit));
  CHECK(convert::has_sure_volume({.volume = 1000, .volume_error = 1}));
  CHECK(!convert::has_sure_volume({.volume = 1000, .volume_error = 1.001}));
  CHECK(convert::has_sure_volume({.volume = -1000, .volume_error = 1}));
  CHECK(!convert::has_sure_volume({.volume = -1000, .volume_error = 1.001}));
  CHECK(convert::has_sure_volume({}));
}

TEST_CASE("the area of a needle is precise although its long sides cancel") {
  // A triangle from (0, 0) to (L, 1) and on by (256, 1 / 2^52) with L = 2^60 + 256: L / 2^52 - 256 is 2^-44, twice the
  // area.
  const std::vector<glm::dvec3> points{{0, 0, 0}, {0x1p60 + 256, 1, 0}, {0x1p60 + 512, 1 + 0x1p-52, 0}};
  for (std::uint32_t first = 0; first < 3; ++first) {
    CAPTURE(first);
    const Surface surface{points, {{first, (first + 1) % 3, (first + 2) % 3}}, {0}};
    CHECK(convert::measure(surface).area == 0x1p-45);
  }
}

TEST_CASE("triangles back to back on the same points cancel") {
  const glm::dvec3 z(0, 0, 1);
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  for (std::uint32_t turn = 0; turn < 3; ++turn) {
    const std::uint32_t a = turn;
    const std::uint32_t b = (turn + 1) % 3;
    const std::uint32_t c = (turn + 2) % 3;
    CHECK(convert::make_surface({points, {{z, loop_of({a, b, c})}, {-z, loop_of({c, b, a})}}}).triangles.empty());
  }
  // Two triangles in one direction and one in the other are not closed. A tetrahedron next to a pair that cancels is
  // unchanged.
  CHECK_THROWS_AS(
      convert::make_surface({points, {{z, loop_of({0, 1, 2})}, {z, loop_of({0, 1, 2})}, {-z, loop_of({0, 2, 1})}}}),
      std::logic_error);
  const Surface alone = tetrahedron();
  const glm::dvec3 slant = glm::normalize(glm::dvec3(6, 3, 2));
  Outlines outlines{alone.points,
                    {{-z, loop_of({0, 2, 1})},
                     {{0, -1, 0}, loop_of({0, 1, 3})},
                     {slant, loop_of({1, 3, 2})},
                     {-slant, loop_of({1, 2, 3})},
                     {{-1, 0, 0}, loop_of({0, 3, 2})},
                     {slant, loop_of({1, 2, 3})}}};
  const Surface made = convert::make_surface(outlines);
  CHECK(made.triangles.size() == 4);
  CHECK(made.points.size() == 4);
  CHECK(convert::measure(made).volume == doctest::Approx(1));
  CHECK(std::ranges::is_sorted(made.outlines));
  CHECK(testing::fault_of(testing::judged(made)) == "");
}

TEST_CASE("a surface with outlines that are not closed is rejected") {
  CHECK_THROWS_WITH_AS(convert::make_surface({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 0, 1}, loop_of({0, 1, 2})}}}),
                       "the boundary of the model is not closed", std::logic_error);
}

TEST_CASE("triangles have the orientation and order of their outlines") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    CAPTURE(seed);
    const model::Tree tree = read::read_csg_text(testing::random_model(seed, 5), "m.csg");
    if (tree.root == model::no_index) continue;
    const Outlines outlines = convert::boundary(tree);
    CHECK(out_of_outlines(convert::make_surface(outlines), outlines) == "");
  }
}

TEST_CASE("a self-touching edge gets a separate midpoint per part") {
  // Bars connect both sides of the edge: two cubes share an edge along z, and slabs below and above connect them.
  const std::string cubes =
      "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,1],[0,0,0,1]]){cube([2,2,1]);}"
      "multmatrix([[1,0,0,2],[0,1,0,2],[0,0,1,1],[0,0,0,1]]){cube([2,2,1]);}";
  const std::string slabs = "cube([4,4,1]);multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,2],[0,0,0,1]]){cube([4,4,1]);}";
  const model::Tree tree = read::read_csg_text(cubes + slabs, "m.csg");
  const Outlines outlines = convert::boundary(tree);
  const Surface surface = convert::make_surface(outlines);
  CHECK(testing::sides_fault_of(testing::judged(surface)) == "");
  CHECK(out_of_outlines(surface, outlines) == "");
  const Measures measures = convert::measure(surface);
  CHECK(measures.volume == doctest::Approx(2 * 4 * 1 + 2 * 16));
  CHECK(measures.area == doctest::Approx(2 * 16 + 4 * 4 * 3 + 2 * 8));
  CHECK(measures.shells == 1);
  // Four faces meet at (2, 2) from z = 1 to 2; each pair has a separate midpoint.
  CHECK(std::ranges::count(surface.points, glm::dvec3(2, 2, 1.5)) == 2);
  CHECK(std::ranges::count_if(surface.points, [](const glm::dvec3& point) { return point.z == 1.5; }) == 2);
}
