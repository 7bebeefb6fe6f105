#include "host/csg/positive_tree.h"
#include "host/facet/planes.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"
#include "host/read/read.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/boundary.h"
#include "sim/software/convert/exact_faces.h"
#include "sim/software/convert/fragments.h"
#include "sim/software/convert/side_by_side.h"
#include "sim/software/convert/surface.h"
#include "sim/software/planes/whole_planes.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"

using namespace csgsim;
namespace convert = software::convert;
using convert::Bodies;
using convert::Body;

namespace {

model::Tree tree_of(const std::string& csg) { return read::read_csg_text(csg, "m.csg"); }

std::string at(const std::string& x, const std::string& y, const std::string& z, const std::string& what) {
  return "multmatrix([[1,0,0," + x + "],[0,1,0," + y + "],[0,0,1," + z + "],[0,0,0,1]]){" + what + "}";
}

std::size_t planes_of(const std::string& csg) { return convert::make_bodies(tree_of(csg), {}).faces.size(); }

/// A unit cube as a body without some of its faces: face 2 axis is the lower one, 2 axis + 1 the upper.
Body open_cube(const std::set<std::uint32_t>& missing, const software::WholePlanes& planes, const Work& work = {}) {
  model::Primitive primitive;
  primitive.shape = model::Cube{{1, 1, 1}, false};
  facet::Solid solid = facet::make_solid(primitive);
  Body body;
  std::vector<std::uint32_t> face_of;
  std::vector<facet::Face> faces;
  for (const facet::Face& face : solid.faces) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double across = face.plane.normal[static_cast<int>(axis)];
      const std::uint32_t number = 2 * axis + (across > 0 ? 1 : 0);
      if (across == 0 || missing.contains(number)) continue;
      face_of.push_back(static_cast<std::uint32_t>(body.faces.size()));
      body.faces.push_back({.halfspace = {number, across > 0}, .box = {}});
      faces.push_back(face);
    }
  }
  solid.faces = faces;
  convert::ExactFaces exact(planes, glm::dvec3(0), 1e-9, work);
  exact.complete(solid, face_of, body);
  return body;
}

/// Planes of the cube, in a larger box.
software::WholePlanes cube_planes() {
  std::vector<facet::Plane> given;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double place : {0.0, 1.0}) {
      facet::Plane plane{glm::dvec3(0), -place};
      plane.normal[axis] = 1;
      given.push_back(plane);
    }
  }
  return {given, {glm::dvec3(-2), glm::dvec3(3)}};
}

std::vector<std::vector<convert::Fragment>> parts_of(const model::Tree& tree, const Work& work = {}) {
  const Bodies bodies = convert::make_bodies(tree, {});
  std::vector<std::vector<convert::Fragment>> found;
  convert::find_fragments(
      bodies, csg::make_positive_tree(tree), std::vector<bool>(bodies.bodies.size(), false),
      [&](std::span<const convert::Fragment> one) { found.emplace_back(one.begin(), one.end()); }, work);
  return found;
}

std::vector<bool> unsplit_bodies(const std::string& csg, const Work& work = {}) {
  const model::Tree tree = tree_of(csg);
  return convert::side_by_side(convert::make_bodies(tree, {}), csg::make_positive_tree(tree), work);
}

/// A cube from -1 to 1, and a second one with an edge that crosses the first one's edge at x = y = 1, starting at
/// (place, place, 0).
std::string crossed_edges(const std::string& place) {
  return at("-1", "-1", "-1", "cube([2,2,2]);") + "multmatrix([[0.70710678118654752,0.5,0.5," + place +
         "],[-0.70710678118654752,0.5,0.5," + place + "],[0,0.70710678118654752,-0.70710678118654752,0],[0,0,0,1]]){" +
         at("-1", "0", "0", "cube([2,2,2]);") + "}";
}

}  // namespace

TEST_CASE("an unbounded body extends to the outermost wall") {
  const software::WholePlanes planes = cube_planes();
  const double unit = planes.unit();
  const Body closed = open_cube({}, planes);
  CHECK(closed.faces.size() == 6);
  CHECK(closed.sides.size() == 24);
  for (std::uint32_t face = 0; face < 6; ++face) {
    CAPTURE(face);
    const auto axis = static_cast<int>(face / 2);
    const bool is_upper = face % 2 == 1;
    const Body open = open_cube({face}, planes);
    CHECK(open.faces.size() == 5 + 6);
    glm::dvec3 low(0);
    glm::dvec3 high(1);
    const std::uint32_t wall = planes.wall(axis, is_upper ? software::WholePlanes::walls - 1 : 0);
    (is_upper ? high : low)[axis] = planes.place_of(wall) * unit;
    CHECK((is_upper ? high[axis] > 3 : low[axis] < -2));
    CHECK(glm::distance(open.box.low * unit, low) < 1e-9);
    CHECK(glm::distance(open.box.high * unit, high) < 1e-9);
    CHECK(open.sides.size() == 24);
  }
  // A body between the upper and the lower half-space of a single plane is empty.
  Body flat = closed;
  flat.faces[1].halfspace = {flat.faces[0].halfspace.plane, !flat.faces[0].halfspace.positive};
  flat.sides.clear();
  flat.box = {};
  const Work unlimited;
  convert::ExactFaces(planes, glm::dvec3(0), 1e-9, unlimited)
      .complete({.vertices = flat.vertices, .faces = {}, .edges = {}, .curved = {}}, {}, flat);
  CHECK(flat.sides.empty());
  CHECK(flat.box.empty());
}

TEST_CASE("faces share a plane only within the tolerance for merging") {
  // Two plates of 0.1 with a gap between them. Six of their planes coincide, or more when the gap counts as closed:
  // three or four remain across x, two across y and z. Within 1e8 the tolerance is 1e-5 of the thickness, and 0.3
  // counts; at 5e11 rounding is 2^-50 of that, 4.4e-4, limited to a thousandth of the thickness.
  const auto planes = [](const std::string& far, const std::string& second) {
    return planes_of(at("0", far, "0", "cube([0.1,1e8,1e8]);") + at(second, far, "0", "cube([0.1,1e8,1e8]);"));
  };
  CHECK(planes("0", "0.1000002") == 7);
  CHECK(planes("0", "0.1000004") == 8);
  CHECK(planes("0", "0.10005") == 8);
  CHECK(planes("5e11", "0.1000004") == 7);
  CHECK(planes("5e11", "0.10005") == 7);
  CHECK(planes("5e11", "0.1002") == 8);
}

TEST_CASE("slightly rotated planes are compared at the location of their solids") {
  // The second cube is tilted by 1e-13 about its own location, where its planes move by as little. A rotation about the
  // origin, a million units away, would move them by 1e-7.
  const std::string beside = "multmatrix([[1,0,0,1],[0,1,0,1e6],[0,1e-13,1,0],[0,0,0,1]]){cube([1,1,1]);}";
  CHECK(planes_of(at("0", "1e6", "0", "cube([1,1,1]);") + beside) == 7);
}

TEST_CASE("an edge shorter than 2^-48 of the largest coordinate collapses to a point") {
  // A step of at least a thousandth from one cube to the next; at 5e11 the limit is 0.00178. The section has six
  // corners with the step and five without.
  struct Step {
    const char* far;
    const char* height;
    std::size_t points;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const Step& row : {Step{"5e11", "1.001", 10}, Step{"5e11", "1.0025", 12}, Step{"5e5", "1.001", 12}}) {
      CAPTURE(axis);
      CAPTURE(row.far);
      CAPTURE(row.height);
      // The cubes overlap along the next axis; their heights along the axis after it are 1 and the step.
      const auto i = static_cast<std::size_t>(axis);
      std::array<std::string, 3> first{"0", "0", "0"};
      first[i] = row.far;
      std::array<std::string, 3> second = first;
      second[(i + 1) % 3] = "1";
      std::array<std::string, 3> size{"1024", "1024", "1024"};
      size[(i + 1) % 3] = "1.5";
      size[(i + 2) % 3] = "1";
      std::array<std::string, 3> other = size;
      other[(i + 2) % 3] = row.height;
      const convert::Surface surface = testing::converted(
          at(first[0], first[1], first[2], "cube([" + size[0] + "," + size[1] + "," + size[2] + "]);") +
          at(second[0], second[1], second[2], "cube([" + other[0] + "," + other[1] + "," + other[2] + "]);"));
      CHECK(testing::sides_fault_of(testing::judged(surface)) == "");
      CHECK(surface.points.size() == row.points);
    }
  }
}

TEST_CASE("a face stays whole if none of many nearby faces cuts it") {
  // Cubes starting at (a, 10.5 - a) next to the slanting side of a triangular prism: their planes pass through its
  // ends, the cubes do not.
  std::string csg =
      "linear_extrude(height=1,center=false,convexity=1,scale=[1,1],$fn=0,$fa=12,$fs=2){"
      "polygon(points=[[0,0],[10,0],[0,10]],paths=undef,convexity=1);}";
  for (int a = 1; a <= 8; ++a) csg += at(std::to_string(a), std::to_string(10.5 - a), "-1", "cube([0.875,0.875,3]);");
  const model::Tree tree = tree_of(csg);
  const auto found = parts_of(tree);
  REQUIRE(found.size() == 9);
  CHECK(found[0].size() == 5);
  for (std::size_t i = 1; i < 9; ++i) CHECK(found[i].size() == 6);
  const convert::Surface surface = testing::converted(tree);
  CHECK(testing::sides_fault_of(testing::judged(surface)) == "");
  CHECK(convert::measure(surface).volume == doctest::Approx(50 + 8 * 0.875 * 0.875 * 3));
  CHECK(convert::measure(surface).shells == 9);
}

TEST_CASE("a plate with many bars and bores has the expected volume and area") {
  // A plate of 10 by 10 with twelve 1 by 1 bars through it in three rows; each third one is a bore.
  std::string bars;
  std::string bores;
  for (int i = 0; i < 12; ++i) {
    const std::string x = std::to_string(1 + 2 * (i % 4));
    const std::string y = std::to_string(1 + 3 * (i / 4));
    (i % 3 == 0 ? bores : bars) += at(x, y, "-1", "cube([1,1,3]);");
  }
  const convert::Surface surface =
      testing::converted("difference(){union(){cube([10,10,1]);" + bars + "}" + bores + "}");
  CHECK(testing::fault_of(testing::judged(surface)) == "");
  const convert::Measures measures = convert::measure(surface);
  CHECK(measures.volume == doctest::Approx(100 + 8 * 2 - 4));
  CHECK(measures.area == doctest::Approx(2 * 100 + 40 + 8 * (4 * 2) + 4 * (4 - 2)));
  CHECK(measures.shells == 1);
  CHECK(measures.genus() == 4);
}

TEST_CASE("fragments of faces refer to the vertices at their corners") {
  // Seven corners of the first cube remain, and one corner of the second lies in it.
  const auto found = parts_of(tree_of("difference(){cube([4,4,4]);" + at("2", "2", "2", "cube([4,4,4]);") + "}"));
  REQUIRE(found.size() == 2);
  for (const std::size_t body : {std::size_t{0}, std::size_t{1}}) {
    std::set<std::uint32_t> vertices;
    for (const convert::Fragment& fragment : found[body]) {
      for (const convert::FragmentCorner& corner : fragment.corners)
        if (corner.vertex != convert::no_vertex) vertices.insert(corner.vertex);
    }
    CHECK(vertices.size() == (body == 0 ? 7 : 1));
  }
}

TEST_CASE("bodies separated by a plane between crossing edges are not split") {
  CHECK(unsplit_bodies(crossed_edges("1.05")) == std::vector<bool>{true, true});
  CHECK(unsplit_bodies(crossed_edges("1")) == std::vector<bool>{true, true});
  CHECK(unsplit_bodies(crossed_edges("0.95")) == std::vector<bool>{false, false});
  const convert::Surface surface = testing::converted(crossed_edges("0.95"));
  CHECK(testing::fault_of(testing::judged(surface)) == "");
}

TEST_CASE("converting one cube and two takes the hand-calculated work") {
  // Each of six faces is cut by its four neighbours at the cost of its corners, one and a quarter each time: 2.
  const model::Tree cube = tree_of("cube([1,1,1]);");
  const Work bodies(1'000'000);
  convert::make_bodies(cube, {}, bodies);
  CHECK(bodies.done() == 6 * 4 * 2);
  // The search for adjacent bodies is charged once for the body itself.
  const Work alone(1'000'000);
  CHECK(unsplit_bodies("cube([1,1,1]);", alone) == std::vector<bool>{true});
  CHECK(alone.done() == 1);
  const Work both(1'000'000);
  convert::boundary(cube, {}, both);
  CHECK(both.done() == 48 + 1);
  // Fragments are charged for one near body, and for each face once and with one operand.
  const Work parts(1'000'000);
  CHECK(parts_of(cube, parts).at(0).size() == 6);
  CHECK(parts.done() == 1 + 6 * (1 + 1));
  // Two touching cubes: each is near both; the first is beyond one of the six faces of the second.
  const Work two(1'000'000);
  unsplit_bodies("cube([1,1,1]);" + at("1", "0", "0", "cube([1,1,1]);"), two);
  CHECK(two.done() == 2 * 2 + 6);
  // The faces of each cube are tested against the other cube, and then all pairs of their twelve edges.
  const Work edges(1'000'000);
  unsplit_bodies(crossed_edges("1.05"), edges);
  CHECK(edges.done() == 2 * 2 + 6 + 6 + 12 * 12);
}
