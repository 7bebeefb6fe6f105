#include <glm/common.hpp>

#include "tests/support/test.h"
#include "tests/unit/read/support.h"

using csgsim::model::Polyhedron;

namespace {

struct Extent {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};
};

/// Extent of the solids that resize() returns for its children.
Extent resized(std::string_view arguments, std::string_view children) {
  Extent extent;
  for (const auto& primitive :
       csgsim::read_test::read(fmt::format("resize({}) {{{}}}", arguments, children)).primitives) {
    for (const glm::dvec3& point : std::get<Polyhedron>(primitive.shape).points) {
      extent.low = glm::min(extent.low, point);
      extent.high = glm::max(extent.high, point);
    }
  }
  return extent;
}

void check_extent(const Extent& extent, const glm::dvec3& low, const glm::dvec3& high) {
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(extent.low[axis] == doctest::Approx(low[axis]));
    CHECK(extent.high[axis] == doctest::Approx(high[axis]));
  }
}

constexpr std::string_view one = "cube([2,3,4]);";
constexpr std::string_view combined = "difference() { cube([2,3,4]); cube(1); }";

}  // namespace

// Expected extents are OpenSCAD 2021.01's exports.
TEST_CASE("a negative new size of a single solid counts as none") {
  check_extent(resized("newsize = [-5,0,0]", one), {0, 0, 0}, {2, 3, 4});
  check_extent(resized("newsize = [-5,0,0], auto = true", one), {0, 0, 0}, {2, 3, 4});
  check_extent(resized("newsize = [-5,0,6], auto = true", one), {0, 0, 0}, {3, 4.5, 6});
}

TEST_CASE("a negative new size mirrors the result of a Boolean") {
  check_extent(resized("newsize = [-5,0,0]", combined), {-5, 0, 0}, {0, 3, 4});
  check_extent(resized("newsize = [-5,0,6], auto = true", combined), {-5, 0, 0}, {0, 4.5, 6});
}
