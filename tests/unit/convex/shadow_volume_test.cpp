#include "host/convex/shadow_volume.h"

#include "host/convex/clip.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convex/light.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using namespace convex;
using namespace testing;

namespace {

/// Length of the open segment inside the polytope, relative to the segment; negative if it misses.
double overlap(const TestModel& model, const convex::Polytope& polytope, const glm::dvec3& from, const glm::dvec3& to) {
  double first = 0;
  double last = 1;
  for (const convex::Face& face : polytope.faces) {
    const double here = testing::signed_distance(model.scene, face.halfspace, from);
    const double there = testing::signed_distance(model.scene, face.halfspace, to);
    if (here > 0 && there > 0) return -1;
    if (here > 0) first = std::max(first, here / (here - there));
    if (there > 0) last = std::min(last, here / (here - there));
  }
  return last - first;
}

/// Checks properties that hold for every volume.
void check_description(const TestModel& model, const convex::Polytope& polytope, const Light& light,
                       const ShadowVolume& volume) {
  const double near = 3.0 * convex::tolerance(model.scene.planes);
  const glm::dvec3 centre = model.scene.planes.centre();
  for (const glm::dvec3& vertex : polytope.vertices) REQUIRE(signed_distance(model, volume, vertex + centre) <= near);
  std::vector<facet::Plane> planes = volume.silhouette;
  for (const facet::Plane& plane : volume.silhouette) {
    REQUIRE(glm::length(plane.normal) == doctest::Approx(1.0).epsilon(1e-12));
    const glm::dvec3 place(light.place);
    const double at_light = light.place.w == 0.0
                                ? glm::dot(plane.normal, glm::normalize(place))
                                : glm::dot(plane.normal, place / light.place.w - centre) + plane.offset;
    REQUIRE(std::abs(at_light) <= near);
  }
  for (const auto* list : {&volume.facing, &volume.edge_on}) {
    for (const facet::Halfspace& halfspace : *list)
      planes.push_back(convex::outward_plane(halfspace, model.scene.planes));
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    // Every plane bounds the volume along at least an edge, and no plane occurs twice.
    const auto touching = std::count_if(volume.corners.begin(), volume.corners.end(), [&](const glm::dvec3& corner) {
      return std::abs(glm::dot(planes[i].normal, corner - centre) + planes[i].offset) <= near;
    });
    REQUIRE(touching >= 2);
    for (const glm::dvec3& direction : volume.directions) REQUIRE(glm::dot(planes[i].normal, direction) <= near);
    for (std::size_t other = 0; other < i; ++other) {
      const double apart = glm::length(planes[i].normal - planes[other].normal) +
                           std::abs(planes[i].offset - planes[other].offset) / model.scene.planes.diagonal();
      REQUIRE(apart > facet::coincidence_tolerance);
    }
  }
}

/// Checks a point deep in the far part of the volume and near its polytope.
void check_extent(const ShadowVolume& volume, const glm::dvec3& point, const glm::dvec3& functional, double near) {
  for (const glm::dvec3& direction : volume.directions) {
    if (glm::dot(functional, direction) > 0.0) return;
  }
  double highest = -1e300;
  for (const glm::dvec3& corner : volume.corners) highest = std::max(highest, glm::dot(functional, corner));
  REQUIRE(glm::dot(functional, point) <= highest + near);
}

ShadowVolume volume_of(const TestModel& model, const glm::dvec4& place) {
  const convex::Polytope polytope = convex::make_polytope(model.scene.solids.front(), model.scene.planes);
  ShadowVolume volume = convex::shadow_volume(polytope, {place}, model.scene.planes);
  if (!volume.everything()) check_description(model, polytope, {place}, volume);
  return volume;
}

}  // namespace

TEST_CASE("a box has the expected lit faces and silhouette edges for each light") {
  const TestModel box("cube(size=[2,2,2],center=true);");
  struct Expected {
    glm::dvec4 light;
    std::size_t facing, edge_on, silhouette, corners;
  };
  for (const Expected& one :
       {Expected{{1, 2, 3, 0}, 3, 0, 6, 7}, Expected{{0, 1, -1, 0}, 2, 2, 2, 6}, Expected{{0, 0, 5, 0}, 1, 4, 0, 4},
        Expected{{5, 6, 7, 1}, 3, 0, 6, 7}, Expected{{0, 0, 5, 1}, 1, 0, 4, 4}, Expected{{1, 0, 5, 1}, 1, 1, 3, 4},
        Expected{{1, 1, 5, 1}, 1, 2, 2, 4}, Expected{{0.5, 5, 5, 1}, 2, 0, 6, 6}}) {
    CAPTURE(one.light.x);
    CAPTURE(one.light.y);
    CAPTURE(one.light.z);
    const ShadowVolume volume = volume_of(box, one.light);
    CHECK(volume.facing.size() == one.facing);
    CHECK(volume.edge_on.size() == one.edge_on);
    CHECK(volume.silhouette.size() == one.silhouette);
    CHECK(volume.corners.size() == one.corners);
    CHECK(volume.directions.size() == (one.light.w == 0.0 ? 1 : one.corners));
    CHECK(!volume.everything());
  }
}

TEST_CASE("a light inside shadows everything and one on the surface the half behind it") {
  const TestModel box("cube(size=[2,2,2],center=true);");
  CHECK(volume_of(box, {0.3, -0.2, 0.9, 1}).everything());
  CHECK(volume_of(box, {0.6, -0.4, 1.8, 2}).everything());
  const glm::dvec4 places[] = {{0.3, 0.2, 1, 1}, {0.3, 1, 1, 1}, {-1, 1, 1, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    const ShadowVolume volume = volume_of(box, places[i]);
    CHECK(!volume.everything());
    CHECK(volume.facing.empty());
    CHECK(volume.silhouette.empty());
    CHECK(volume.edge_on.size() == i + 1);
    CHECK(signed_distance(box, volume, {0, 0, -50}) < 0.0);
    CHECK(signed_distance(box, volume, {0, 0, 50}) > 0.0);
  }
}

TEST_CASE("a prism and an octahedron have one shadow plane per silhouette edge") {
  // 16 sides and a cap are lit: the silhouette has 16 edges of each cap and two edges between sides.
  const TestModel prism("cylinder($fn=32,$fa=12,$fs=2,h=4,r1=3,r2=3,center=true);");
  const ShadowVolume volume = volume_of(prism, {1, 0.03, 0.5, 0});
  CHECK(volume.facing.size() == 17);
  CHECK(volume.edge_on.empty());
  CHECK(volume.silhouette.size() == 16 + 16 + 2);

  const TestModel octahedron(
      "polyhedron(points=[[1,0,0],[-1,0,0],[0,1,0],[0,-1,0],[0,0,1],[0,0,-1]],faces=[[0,2,4],[2,1,4],[1,3,4],[3,0,4],"
      "[2,0,5],[1,2,5],[3,1,5],[0,3,5]],convexity=1);");
  const ShadowVolume square = volume_of(octahedron, {1, 0, 0, 0});
  CHECK(square.facing.size() == 4);
  CHECK(square.silhouette.size() == 4);
  // Along an edge's normal two faces are lit and the four adjacent ones are edge-on.
  const ShadowVolume rhombus = volume_of(octahedron, {1, 1, 0, 0});
  CHECK(rhombus.facing.size() == 2);
  CHECK(rhombus.edge_on.size() == 4);
  CHECK(rhombus.silhouette.empty());
}

TEST_CASE("collinear edges of coplanar faces give a single shadow plane") {
  const TestModel box("cube(size=[2,2,2],center=true);");
  convex::Polytope polytope = convex::make_polytope(box.scene.solids.front(), box.scene.planes);
  // The top face is split in two, between the midpoints of opposite edges.
  const auto top = std::find_if(polytope.faces.begin(), polytope.faces.end(), [&](const convex::Face& face) {
    return convex::outward_plane(face.halfspace, box.scene.planes).normal.z > 0.5;
  });
  REQUIRE(top != polytope.faces.end());
  const std::vector<std::uint32_t> c = top->corners;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto added = static_cast<std::uint32_t>(polytope.vertices.size());
    polytope.vertices.push_back((polytope.vertices[a] + polytope.vertices[b]) / 2.0);
    for (convex::Face& face : polytope.faces) {
      for (std::size_t i = 0; i < face.corners.size(); ++i) {
        if (face.corners[i] != b || face.corners[(i + 1) % face.corners.size()] != a) continue;
        face.corners.insert(face.corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, added);
        break;
      }
    }
    return added;
  };
  const std::uint32_t m = middle(c[0], c[1]);
  const std::uint32_t n = middle(c[2], c[3]);
  top->corners = {c[0], m, n, c[3]};
  polytope.faces.push_back({top->halfspace, {m, c[1], c[2], n}});
  REQUIRE(testing::describe_flaws(box.scene, polytope) == "");
  for (const glm::dvec4& place : {glm::dvec4(1, 2, 3, 0), glm::dvec4(-1, -2, 3, 0), glm::dvec4(0.2, 0.1, 3, 1)}) {
    const ShadowVolume volume = convex::shadow_volume(polytope, {place}, box.scene.planes);
    const ShadowVolume whole = volume_of(box, place);
    check_description(box, polytope, {place}, volume);
    CHECK(volume.facing.size() == whole.facing.size());
    CHECK(volume.silhouette.size() == whole.silhouette.size());
  }
}

TEST_CASE("a point is in a shadow volume exactly if its segment to the light hits") {
  testing::RandomPoints random(1977);
  int shadowed = 0;
  int lit = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    const TestModel model(testing::random_model(seed, 1 + static_cast<unsigned>(seed % 8)));
    if (model.solids.empty()) continue;
    const std::vector<convex::Piece> pieces = model.pieces();
    const double diagonal = model.scene.planes.diagonal();
    for (std::size_t i = 0; i < std::min<std::size_t>(pieces.size(), 12); ++i) {
      const convex::Polytope& polytope = pieces[random.below(pieces.size())].polytope;
      const Light light = testing::random_light(model, random);
      const ShadowVolume volume = convex::shadow_volume(polytope, light, model.scene.planes);
      if (volume.everything()) {
        REQUIRE(testing::signed_distance(model.scene, polytope, glm::dvec3(light.place)) < 0.0);
      } else {
        check_description(model, polytope, light, volume);
      }
      for (int k = 0; k < 40; ++k) {
        const glm::dvec3 point = random.around(model.scene.solids[pieces[i].primitive].box);
        const double above = signed_distance(model, volume, point);
        const double part = overlap(model, polytope, point, testing::end_of_segment(model, light, point));
        if (std::abs(above) < doubtful * diagonal || std::abs(part) < doubtful) continue;
        REQUIRE((above < 0.0) == (part > 0.0));
        ++(part > 0.0 ? shadowed : lit);
        if (part > 0.0) check_extent(volume, point, random.direction(), doubtful * diagonal);
      }
    }
  }
  CHECK(shadowed > 2000);
  CHECK(lit > 2000);
}
