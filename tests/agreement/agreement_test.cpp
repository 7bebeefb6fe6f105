#include "hw/isa/depth_scale.h"
#include "hw/isa/facts.h"
#include "places.h"
#include "tests/agreement/mesh_depth.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

struct Difference {
  int silhouette = 0;  ///< pixels covered in one picture only
  int covered = 0;     ///< pixels covered in both
  int deep = 0;        ///< covered pixels whose depths differ by more than a thousandth of the model's diagonal
};

Difference compare(const std::string& name, const view::Camera& camera) {
  constexpr int size = 512;
  const testing::Mesh mesh =
      testing::read_off(std::string(CSGSIM_SOURCE_DIR) + "/tests/agreement/meshes/" + name + ".off");
  const bool perspective = camera.projection == view::Projection::perspective;
  const std::vector<double> expected = testing::mesh_depth(mesh, camera.eye, camera.centre, perspective, size);
  const testing::Compiled compiled = testing::compile_file(testing::model_path(name), {camera, {}, 72});
  const observe::Frame frame = testing::draw(compiled.program);
  const double limit = testing::diagonal(mesh) / 1000.0;
  Difference difference;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double depth = isa::distance_of(compiled.program.facts->depth_scale, 20, frame.depth[i]);
    if (std::isfinite(depth) != std::isfinite(expected[i])) {
      ++difference.silhouette;
    } else if (std::isfinite(depth)) {
      ++difference.covered;
      if (std::abs(depth - expected[i]) > limit) ++difference.deep;
    }
  }
  return difference;
}

void check(const std::string& name, const glm::dvec3& eye, const glm::dvec3& centre) {
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    const Difference difference = compare(name, {eye, centre, projection});
    CAPTURE(name);
    CAPTURE(static_cast<int>(projection));
    CHECK(difference.covered > 10'000);
    CHECK(difference.silhouette <= 4);
    CHECK(difference.deep * 2000 <= difference.covered);
  }
}

}  // namespace

TEST_CASE("the object of fig. 2.3 agrees with the depths of OpenSCAD's mesh") {
  check("thesis_fig_2_3", {42, -38, 41}, {10, 5.5, 2});
}
TEST_CASE("the carburettor agrees with the depths of OpenSCAD's mesh") {
  check("carburettor", {220, -255, 135}, {2, 0, 5});
}
TEST_CASE("the terrain vehicle agrees with the depths of OpenSCAD's mesh") {
  check("terrain_vehicle", {560, -590, 420}, {-5, 0, 68});
}
TEST_CASE("the Rietveld house agrees with the depths of OpenSCAD's mesh") {
  check("rietveld_house", {3430, -2900, 1950}, {590, 230, 220});
}
TEST_CASE("set operations on a cube and a sphere agree with the depths of OpenSCAD's mesh") {
  check("basics_csg", {70, -152, 92}, {-1, 0, 0});
}
TEST_CASE("a drilled cube cut to a cone agrees with the depths of OpenSCAD's mesh") {
  check("old_example002", {65, -95, 60}, {0, 0, -2});
}
TEST_CASE("a cube with bosses and holes agrees with the depths of OpenSCAD's mesh") {
  check("old_example003", {75, -100, 65}, {0, 0, 0});
}
TEST_CASE("a polyhedron agrees with the depths of OpenSCAD's mesh") {
  check("old_example011", {28, -40, 25}, {0, 0, 4});
}
