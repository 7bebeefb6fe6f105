#include "host/convex/face_polygon.h"

#include "host/convex/polytope.h"
#include "tests/support/test.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using testing::TestModel;

namespace {

/// Area by the shoelace formula; 0 without corners.
double area_of(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < corners.size(); ++i) sum += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
  return glm::length(sum) / 2;
}

std::vector<glm::dvec3> corners_of(const convex::Polytope& polytope, std::uint32_t plane) {
  std::vector<glm::dvec3> corners;
  for (const convex::Face& face : polytope.faces) {
    if (face.halfspace.plane != plane) continue;
    for (const std::uint32_t corner : face.corners) corners.push_back(polytope.vertices[corner]);
  }
  return corners;
}

/// Whether each point of `some` equals one of `others` to rounding.
bool are_among(const std::vector<glm::dvec3>& some, const std::vector<glm::dvec3>& others, double near) {
  return std::ranges::all_of(some, [&](const glm::dvec3& one) {
    return std::ranges::any_of(others, [&](const glm::dvec3& other) { return glm::distance(one, other) <= near; });
  });
}

}  // namespace

TEST_CASE("a face's polygon matches the corresponding face of the polytope") {
  const std::string turned = "multmatrix([[0.36,0.48,-0.8,7],[-0.8,0.6,0,-3],[0.48,0.64,0.6,11],[0,0,0,1]])";
  for (const std::string& solid :
       {std::string("cube(size=[2,3,5],center=false);"), std::string("sphere($fn=24,$fa=12,$fs=2,r=4);"),
        std::string("cylinder($fn=360,$fa=12,$fs=2,h=3,r1=5,r2=2,center=true);"),
        std::string("cylinder($fn=5,$fa=12,$fs=2,h=3,r1=0,r2=2,center=false);")}) {
    for (const std::string& text : {solid, fmt::format("{}{{{}}}", turned, solid)}) {
      CAPTURE(text);
      const TestModel model(text);
      const convex::Polytope whole = convex::make_polytope(model.scene.solids.front(), model.scene.planes);
      const double near = 1e-9 * model.scene.planes.diagonal();
      for (const facet::Halfspace& halfspace : model.scene.solids.front().halfspaces) {
        const auto expected = corners_of(whole, halfspace.plane);
        const auto found = convex::face_polygon(model.scene.solids.front(), halfspace.plane, model.scene.planes);
        CHECK(are_among(expected, found, near));
        CHECK(are_among(found, expected, near));
        CHECK(area_of(found) == doctest::Approx(area_of(expected)).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("a plane that touches or misses a solid has no polygon") {
  const TestModel model(
      "cube(size=[2,3,5],center=false); multmatrix([[1,0,0,9],[0,1,0,0],[0,0,1,1],[0,0,0,1]]) {"
      "cube(size=[1,1,1],center=false); }");
  const facet::Convex& first = model.scene.solids[0];
  for (const facet::Halfspace& halfspace : model.scene.solids[1].halfspaces) {
    const auto is_same = [&](const facet::Halfspace& one) { return one.plane == halfspace.plane; };
    if (std::ranges::any_of(first.halfspaces, is_same)) continue;
    const auto corners = convex::face_polygon(first, halfspace.plane, model.scene.planes);
    // The planes z = 1, z = 2 and y = 1 cut the larger cube; x = 9 and x = 10 miss it.
    const bool cuts = std::abs(model.scene.planes.planes()[halfspace.plane].normal.x) < 0.5;
    CHECK(corners.empty() == !cuts);
  }
}
