#include "tests/oracle/ray_model.h"

#include "tests/support/test.h"
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
  for (const testing::SurfacePoint& point : model.surfaces({{0, 0, 0}, {0, 1, 0}}, {-infinity}, 1e-6).points) {
    found.emplace_back(point.primitive, point.t);
  }
  return found;
}

using Found = std::vector<std::pair<std::uint32_t, double>>;

/// A box with an edge along z at x = 0, y = 1 towards the origin, and others at x = -2 and x = 2, y = 3.
const std::string upright_edge =
    "multmatrix([[0.7071067811865476,-0.7071067811865476,0,0],[0.7071067811865476,0.7071067811865476,0,1],[0,0,1,0],"
    "[0,0,0,1]]){" +
    box({0, 0, -2}, {2.8284271247461903, 2.8284271247461903, 2}) + "}";

/// Whether all surfaces along +y from a point are certain at a given gap.
bool all_clear(const std::string& csg, const glm::dvec3& from, double gap) {
  const testing::Stage stage(csg);
  const auto found = testing::RayModel(stage.tree, stage.facets).surfaces({from, {0, 1, 0}}, {-infinity}, gap).points;
  REQUIRE(!found.empty());
  return std::all_of(found.begin(), found.end(), [](const testing::SurfacePoint& point) { return point.is_clear; });
}

std::string slab(double from, double to) { return box({-2, from, -2}, {2, to, 2}); }

}  // namespace

TEST_CASE("surfaces of a union are the fronts of its solids including those inside others") {
  CHECK(along_y("union(){" + slab(1, 4) + slab(2, 3) + "}") == Found{{0, 1.0}, {1, 2.0}});
}

TEST_CASE("surfaces of an intersection are the fronts inside all of its solids") {
  CHECK(along_y("intersection(){" + slab(1, 4) + slab(2, 6) + "}") == Found{{1, 2.0}});
  CHECK(along_y("intersection(){" + slab(1, 2) + slab(3, 4) + "}") == Found{});
}

TEST_CASE("a cavity's far wall is the back of the removed solid") {
  CHECK(along_y("difference(){" + slab(1, 9) + slab(3, 5) + "}") == Found{{0, 1.0}, {1, 5.0}});
}

TEST_CASE("a solid subtracted from a subtracted one shows its front") {
  CHECK(along_y("difference(){" + slab(1, 9) + "difference(){" + slab(0, 7) + slab(2, 4) + "}}") ==
        Found{{2, 2.0}, {1, 7.0}});
}

TEST_CASE("a solid minus itself is empty") {
  CHECK(along_y("difference(){" + slab(1, 2) + slab(1, 2) + "}") == Found{});
}

TEST_CASE("touching solids do not intersect and the second starts where the first ends") {
  CHECK(along_y("intersection(){" + slab(1, 2) + slab(2, 3) + "}") == Found{});
  CHECK(along_y("union(){" + slab(1, 2) + slab(2, 3) + "}") == Found{{0, 1.0}, {1, 2.0}});
}

TEST_CASE("a cut that ends at a face leaves no membrane there") {
  CHECK(along_y("difference(){" + slab(1, 4) + slab(0, 4) + "}") == Found{});
  CHECK(along_y("difference(){" + slab(1, 4) + slab(1, 2) + "}") == Found{{1, 2.0}});
}

TEST_CASE("the first of coincident fronts in tree order is the visible surface") {
  CHECK(along_y("union(){" + slab(1, 4) + slab(1, 2) + "}") == Found{{0, 1.0}});
  CHECK(along_y("difference(){union(){" + slab(3, 9) + slab(1, 9) + "}" + slab(0, 3) + "}") == Found{{0, 3.0}});
}

TEST_CASE("a surface within the gap of another plane is in doubt and so is all behind it") {
  const testing::Stage stage("union(){" + slab(1, 2) + slab(1.001, 3) + slab(5, 6) + "}");
  const testing::RayModel model(stage.tree, stage.facets);
  const testing::Ray ray{{0, 0, 0}, {0, 1, 0}};
  for (const testing::SurfacePoint& point : model.surfaces(ray, {-infinity}, 1e-4).points) CHECK(point.is_clear);
  for (const testing::SurfacePoint& point : model.surfaces(ray, {-infinity}, 1e-2).points) CHECK_FALSE(point.is_clear);
}

TEST_CASE("a facet closer than the gap to the next facet of its solid is in doubt") {
  // Beside the edge, at x = 0.001, the facets are at 1.001 and 0.999.
  CHECK(all_clear(upright_edge, {0.001, 0, 0}, 1e-3));
  CHECK_FALSE(all_clear(upright_edge, {0.001, 0, 0}, 3e-3));
}

TEST_CASE("what is seen past an edge within the gap is in doubt") {
  // The path through the solid is 0.002 long at x = 1.999, and misses it by 0.002 at x = 2.001.
  const std::string both = "union(){" + upright_edge + box({-9, 5, -9}, {9, 6, 9}) + "}";
  for (const double x : {1.999, 2.001}) {
    CHECK(all_clear(both, {x, 0, 0}, 1e-3));
    CHECK_FALSE(all_clear(both, {x, 0, 0}, 3e-3));
  }
}

TEST_CASE("the background is in doubt within the gap of an edge") {
  const testing::Stage stage(upright_edge);
  const testing::RayModel model(stage.tree, stage.facets);
  const testing::Ray ray{{2.001, 0, 0}, {0, 1, 0}};
  CHECK(model.surfaces(ray, {-infinity}, 3e-3).points.empty());
  CHECK_FALSE(model.surfaces(ray, {-infinity}, 3e-3).is_clear);
  CHECK(model.surfaces(ray, {-infinity}, 1e-3).is_clear);
}

TEST_CASE("a near plane cuts solids open and the cut has no facet") {
  const testing::Stage stage(slab(1, 4));
  const testing::RayModel model(stage.tree, stage.facets);
  const auto found = model.surfaces({{0, 0, 0}, {0, 1, 0}}, {2}, 1e-4).points;
  REQUIRE(found.size() == 1);
  CHECK(found[0].t == 2);
  CHECK(found[0].halfspace == model::no_index);
  CHECK_FALSE(found[0].is_clear);
}

TEST_CASE("a path to a light is blocked only by solids within its length") {
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

TEST_CASE("a light path that starts on a face is not blocked by the solid it leaves") {
  const testing::Stage stage("union(){" + slab(1, 2) + box({-1, 0, 1}, {1, 2, 3}) + "}");
  const testing::RayModel model(stage.tree, stage.facets);
  const auto found = model.surfaces({{0, 0, 0}, {0, 1, 0}}, {-infinity}, 1e-6).points;
  REQUIRE(found.size() == 1);
  CHECK_FALSE(model.occlusion({{0, 1, 0}, {0, -1, 0}, found[0].plane}, infinity, 1e-6).is_blocked);
  CHECK(model.occlusion({{0, 1, 0}, {0, 1, 0}, found[0].plane}, infinity, 1e-6).is_blocked);
}

TEST_CASE("a light path through less than the gap of a solid is in doubt") {
  const testing::Stage stage(slab(1, 1.001));
  const testing::RayModel model(stage.tree, stage.facets);
  const testing::Ray ray{{0, 0, 0}, {0, 1, 0}};
  CHECK(model.occlusion(ray, infinity, 1e-4).is_clear);
  CHECK_FALSE(model.occlusion(ray, infinity, 1e-2).is_clear);
  CHECK(model.occlusion(ray, infinity, 1e-2).is_blocked);
}

TEST_CASE("two solids thinner than the gap leave a shadow in doubt") {
  const testing::Stage stage("union(){" + slab(1, 1.006) + slab(3, 3.006) + "}");
  const testing::RayModel model(stage.tree, stage.facets);
  CHECK_FALSE(model.occlusion({{0, 0, 0}, {0, 1, 0}}, infinity, 1e-2).is_clear);
}

TEST_CASE("a light path within the gap of an edge is in doubt") {
  const testing::Stage stage(upright_edge);
  const testing::RayModel model(stage.tree, stage.facets);
  const testing::Ray ray{{2.001, 0, 0}, {0, 1, 0}};
  CHECK_FALSE(model.occlusion(ray, infinity, 3e-3).is_blocked);
  CHECK_FALSE(model.occlusion(ray, infinity, 3e-3).is_clear);
  CHECK(model.occlusion(ray, infinity, 1e-3).is_clear);
  CHECK(model.occlusion(ray, 2, 3e-3).is_clear);
}
