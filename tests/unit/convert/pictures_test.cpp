#include "host/model/tree.h"
#include "host/read/read.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/formats.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"

using namespace csgsim;

namespace {

/// The mesh as a polyhedron() in a model file.
std::string as_polyhedron(const software::convert::Surface& surface) {
  std::string points;
  for (const glm::dvec3& point : surface.points)
    points += fmt::format("{}[{},{},{}]", points.empty() ? "" : ",", point.x, point.y, point.z);
  std::string faces;
  for (const software::convert::Triangle& triangle : surface.triangles)
    faces += fmt::format("{}[{},{},{}]", faces.empty() ? "" : ",", triangle[0], triangle[2], triangle[1]);
  return "polyhedron(points=[" + points + "],faces=[" + faces + "],convexity=1);";
}

/// Distance from the eye in model units for a depth of an orthographic picture; empty for background.
std::optional<double> distance_of(const view::View& view, std::uint32_t depth) {
  if (depth == (1U << view.sampling.z_bits) - 1) return std::nullopt;
  return view.depth.near + depth * view.depth_step;
}

}  // namespace

TEST_CASE("a converted mesh looks like its model except at edges") {
  for (const char* const name : {"thesis_fig_2_3", "old_example002", "old_example003"}) {
    CAPTURE(name);
    testing::Setup setup;
    setup.sampling.width = 192;
    setup.sampling.height = 192;
    setup.memory_bits = 256;
    const testing::Compiled model =
        testing::compile_default_view(testing::model_path(name), setup, view::Projection::orthographic);
    testing::Setup same = setup;
    same.camera = model.view.camera;
    const testing::Compiled mesh =
        testing::compile_text(as_polyhedron(testing::converted(read::read_csg_file(testing::model_path(name)))), same);
    const observe::Frame one = testing::draw(model.program);
    const observe::Frame other = testing::draw(mesh.program);
    REQUIRE(one.depth.size() == other.depth.size());
    std::size_t wrong = 0;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < one.depth.size(); ++i) {
      const std::optional<double> here = distance_of(model.view, one.depth[i]);
      const std::optional<double> there = distance_of(mesh.view, other.depth[i]);
      if (here) ++seen;
      const bool is_same = here && there ? std::abs(*here - *there) < 0.01 : here.has_value() == there.has_value();
      if (!is_same) ++wrong;
    }
    CHECK(seen > 5000);
    CHECK(wrong < 20);
  }
}
