#include "tests/oracle/ray_model.h"

#include <doctest/doctest.h>

#include <limits>
#include <utility>

#include "tests/unit/oracle/stage.h"

using namespace csgsim;
using testing::box;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Primitive and depth of every surface along +y through the origin.
std::vector<std::pair<std::uint32_t, double>> along_y(const std::string& csg) {
  const testing::Stage stage(csg);
  const testing::RayModel model(stage.tree, stage.facets);
  std::vector<std::pair<std::uint32_t, double>> found;
  for (const testing::SurfacePoint& point : model.surfaces({{0, 0, 0}, {0, 1, 0}}, {-infinity}, 1e-6)) {
    found.emplace_back(point.primitive, point.t);
  }
  return found;
}

using Found = std::vector<std::pair<std::uint32_t, double>>;

std::string slab(double from, double to) { return box({-2, from, -2}, {2, to, 2}); }

}  // namespace

TEST_CASE("the surfaces of a union are the fronts of its solids, those inside other solids too") {
  CHECK(along_y("union(){" + slab(1, 4) + slab(2, 3) + "}") == Found{{0, 1.0}, {1, 2.0}});
}

TEST_CASE("the surfaces of an intersection are the fronts that all of its solids hold") {
  CHECK(along_y("intersection(){" + slab(1, 4) + slab(2, 6) + "}") == Found{{1, 2.0}});
  CHECK(along_y("intersection(){" + slab(1, 2) + slab(3, 4) + "}") == Found{});
}

TEST_CASE("a cavity's far wall is the back of what was taken away") {
  CHECK(along_y("difference(){" + slab(1, 9) + slab(3, 5) + "}") == Found{{0, 1.0}, {1, 5.0}});
}

TEST_CASE("what is taken away from what is taken away shows its front") {
  CHECK(along_y("difference(){" + slab(1, 9) + "difference(){" + slab(0, 7) + slab(2, 4) + "}}") ==
        Found{{2, 2.0}, {1, 7.0}});
}

TEST_CASE("a solid without itself is empty") {
  CHECK(along_y("difference(){" + slab(1, 2) + slab(1, 2) + "}") == Found{});
}

TEST_CASE("solids that touch do not intersect, and the second begins where the first ends") {
  CHECK(along_y("intersection(){" + slab(1, 2) + slab(2, 3) + "}") == Found{});
  CHECK(along_y("union(){" + slab(1, 2) + slab(2, 3) + "}") == Found{{0, 1.0}, {1, 2.0}});
}

TEST_CASE("a cut that ends at a face leaves no membrane there") {
  CHECK(along_y("difference(){" + slab(1, 4) + slab(0, 4) + "}") == Found{});
  CHECK(along_y("difference(){" + slab(1, 4) + slab(1, 2) + "}") == Found{{1, 2.0}});
}

TEST_CASE("of coincident fronts the first in tree order is the surface") {
  CHECK(along_y("union(){" + slab(1, 4) + slab(1, 2) + "}") == Found{{0, 1.0}});
  CHECK(along_y("difference(){union(){" + slab(3, 9) + slab(1, 9) + "}" + slab(0, 3) + "}") == Found{{0, 3.0}});
}

TEST_CASE("a surface is in doubt where another plane is nearer than the gap, and so is what is behind it") {
  const testing::Stage stage("union(){" + slab(1, 2) + slab(1.001, 3) + slab(5, 6) + "}");
  const testing::RayModel model(stage.tree, stage.facets);
  const testing::Ray ray{{0, 0, 0}, {0, 1, 0}};
  for (const testing::SurfacePoint& point : model.surfaces(ray, {-infinity}, 1e-4)) CHECK(point.is_clear);
  for (const testing::SurfacePoint& point : model.surfaces(ray, {-infinity}, 1e-2)) CHECK_FALSE(point.is_clear);
}

TEST_CASE("a near plane cuts solids open, and the cut has no facet") {
  const testing::Stage stage(slab(1, 4));
  const testing::RayModel model(stage.tree, stage.facets);
  const auto found = model.surfaces({{0, 0, 0}, {0, 1, 0}}, {2}, 1e-4);
  REQUIRE(found.size() == 1);
  CHECK(found[0].t == 2);
  CHECK(found[0].halfspace == model::no_index);
  CHECK_FALSE(found[0].is_clear);
}

TEST_CASE("the way to a light is blocked by what the model holds of it, and by no more than that way") {
  const testing::Stage stage("difference(){" + slab(1, 4) + slab(2, 3) + "}");
  const testing::RayModel model(stage.tree, stage.facets);
  const auto blocked = [&](double from, double to) {
    const testing::Occlusion found = model.occlusion({{0, from, 0}, {0, 1, 0}}, to - from, 1e-6);
    CHECK(found.is_clear);
    return found.is_blocked;
  };
  CHECK(blocked(0, infinity));
  CHECK(blocked(0, 1.5));
  CHECK(blocked(2.5, infinity));
  CHECK_FALSE(blocked(0, 0.5));
  CHECK_FALSE(blocked(2.25, 2.75));
  CHECK_FALSE(blocked(5, infinity));
}

TEST_CASE("a light's way that begins on a face is not blocked by the solid that it leaves") {
  const testing::Stage stage("union(){" + slab(1, 2) + box({-1, 0, 1}, {1, 2, 3}) + "}");
  const testing::RayModel model(stage.tree, stage.facets);
  const auto found = model.surfaces({{0, 0, 0}, {0, 1, 0}}, {-infinity}, 1e-6);
  REQUIRE(found.size() == 1);
  CHECK_FALSE(model.occlusion({{0, 1, 0}, {0, -1, 0}, found[0].plane}, infinity, 1e-6).is_blocked);
  CHECK(model.occlusion({{0, 1, 0}, {0, 1, 0}, found[0].plane}, infinity, 1e-6).is_blocked);
}

TEST_CASE("a light's way through less than the gap of a solid is in doubt") {
  const testing::Stage stage(slab(1, 1.001));
  const testing::RayModel model(stage.tree, stage.facets);
  const testing::Ray ray{{0, 0, 0}, {0, 1, 0}};
  CHECK(model.occlusion(ray, infinity, 1e-4).is_clear);
  CHECK_FALSE(model.occlusion(ray, infinity, 1e-2).is_clear);
  CHECK(model.occlusion(ray, infinity, 1e-2).is_blocked);
}
