#include "host/convex/polytope.h"

#include "host/convex/carver.h"
#include "host/convex/clip.h"
#include "host/convex/merge.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using namespace testing;

namespace {

/// A rotation about an oblique axis, and a shift.
const std::string turned = "multmatrix([[0.36,0.48,-0.8,7],[-0.8,0.6,0,-3],[0.48,0.64,0.6,11],[0,0,0,1]])";

convex::Polytope only_solid(const TestModel& model) {
  return convex::make_polytope(model.scene.solids.front(), model.scene.planes);
}

/// A plane number that no half-space has.
constexpr std::uint32_t no_plane = 0xffffffffU;

/// A box larger than the solid, to be cut by its half-spaces.
convex::Polytope wide_box(const facet::Convex& solid, const facet::PlaneTable& planes) {
  facet::Box box{solid.box.low - planes.centre(), solid.box.high - planes.centre()};
  const glm::dvec3 margin(0.1 * box.diagonal() + 10.0 * convex::tolerance(planes));
  box = {box.low - margin, box.high + margin};
  convex::Polytope polytope;
  for (unsigned corner = 0; corner < 8; ++corner) {
    polytope.vertices.emplace_back((corner & 1U) != 0 ? box.high.x : box.low.x,
                                   (corner & 2U) != 0 ? box.high.y : box.low.y,
                                   (corner & 4U) != 0 ? box.high.z : box.low.z);
  }
  for (const std::vector<std::uint32_t>& corners : std::vector<std::vector<std::uint32_t>>{
           {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
    polytope.faces.push_back({{no_plane, true}, corners});
  return polytope;
}

/// The polytope, or an empty one if part of the initial box remains, that is, if the solid is unbounded.
convex::Polytope if_closed(convex::Polytope polytope) {
  const bool is_open = std::any_of(polytope.faces.begin(), polytope.faces.end(),
                                   [](const convex::Face& face) { return face.halfspace.plane == no_plane; });
  return is_open ? convex::Polytope{} : polytope;
}

/// The intersection, computed only with clip().
convex::Polytope clipped_one_by_one(const facet::Convex& solid, const facet::PlaneTable& planes) {
  convex::Polytope polytope = wide_box(solid, planes);
  for (const facet::Halfspace& halfspace : solid.halfspaces)
    polytope = convex::clip(std::move(polytope), halfspace, planes);
  return if_closed(std::move(polytope));
}

/// Equals clipped_one_by_one() to the bit, as other tests of this file check, but is fast for many half-spaces.
convex::Polytope carved_in_order(const facet::Convex& solid, const facet::PlaneTable& planes) {
  convex::Carver carver(wide_box(solid, planes), planes);
  for (const facet::Halfspace& halfspace : solid.halfspaces) carver.clip(halfspace);
  return if_closed(carver.take());
}

/// Area of a regular polygon inscribed in a circle.
double polygon_area(double radius, double count) {
  return 0.5 * count * radius * radius * std::sin(2.0 * std::numbers::pi / count);
}

}  // namespace

TEST_CASE("a box keeps its structure and volume when rotated or far away") {
  const std::string cube = "cube(size=[2,3,5],center=false);";
  const std::string far = "multmatrix([[1,0,0,1e6],[0,1,0,0],[0,0,1,2e6],[0,0,0,1]])";
  for (const std::string& text :
       {cube, fmt::format("{}{{{}}}", turned, cube), fmt::format("{}{{{}{{{}}}}}", turned, far, cube)}) {
    CAPTURE(text);
    const TestModel model(text);
    const convex::Polytope polytope = only_solid(model);
    CHECK(polytope.faces.size() == 6);
    CHECK(polytope.vertices.size() == 8);
    CHECK(convex::edges(polytope).size() == 12);
    CHECK(convex::volume(polytope) == doctest::Approx(30.0).epsilon(1e-9));
    CHECK(describe_flaws(model.scene, polytope) == "");
  }
}

TEST_CASE("solids have one face per half-space and their geometric volumes") {
  const auto check = [](const std::string& text, double volume, double error = 1e-12) {
    CAPTURE(text);
    const TestModel model(turned + "{" + text + "}");
    const convex::Polytope polytope = only_solid(model);
    CHECK(polytope.faces.size() == model.scene.solids.front().halfspaces.size());
    CHECK(convex::volume(polytope) == doctest::Approx(volume).epsilon(error));
    CHECK(describe_flaws(model.scene, polytope) == "");
  };
  check("cylinder($fn=96,$fa=12,$fs=2,h=7,r1=3,r2=3,center=true);", 7.0 * polygon_area(3, 96));
  check("cylinder($fn=100,$fa=12,$fs=2,h=7,r1=3,r2=0,center=true);", 7.0 / 3.0 * polygon_area(3, 100));
  // Neighbouring normals at the apex differ by 2 pi / 1000, so rounding grows with the square of the reciprocal.
  check("cylinder($fn=1000,$fa=12,$fs=2,h=7,r1=3,r2=0,center=true);", 7.0 / 3.0 * polygon_area(3, 1000), 1e-15 / 4e-5);
  check("cylinder($fn=5,$fa=12,$fs=2,h=6,r1=1,r2=2,center=false);",
        2.0 * (polygon_area(1, 5) + polygon_area(2, 5) + std::sqrt(polygon_area(1, 5) * polygon_area(2, 5))));
  check("polyhedron(points=[[0,0,0],[4,0,0],[0,5,0],[0,0,6]],faces=[[0,1,2],[0,3,1],[0,2,3],[1,3,2]],convexity=1);",
        20.0);
  // A stack of frusta between the rings of OpenSCAD's sphere.
  const int count = 30;
  const int rings = 15;
  double volume = 0;
  for (int i = 0; i + 1 < rings; ++i) {
    const auto polar = [&](int ring) { return std::numbers::pi * (ring + 0.5) / rings; };
    const double low = polygon_area(2.0 * std::sin(polar(i)), count);
    const double high = polygon_area(2.0 * std::sin(polar(i + 1)), count);
    volume += 2.0 * (std::cos(polar(i)) - std::cos(polar(i + 1))) / 3.0 * (low + high + std::sqrt(low * high));
  }
  check("sphere($fn=30,$fa=12,$fs=2,r=2);", volume);
}

TEST_CASE("a sphere faceted to a tolerance is a polytope between two spheres") {
  const TestModel model(turned + "{sphere($fn=0,$fa=12,$fs=2,r=2);}");
  const facet::Geometry scene = facet::make_geometry(model.tree, {0.02, std::nullopt});
  const convex::Polytope polytope = convex::make_polytope(scene.solids.front(), scene.planes);
  CHECK(polytope.faces.size() == scene.solids.front().halfspaces.size());
  CHECK(describe_flaws(scene, polytope) == "");
  CHECK(convex::volume(polytope) < 4.0 / 3.0 * std::numbers::pi * 8.0);
  CHECK(convex::volume(polytope) > 4.0 / 3.0 * std::numbers::pi * std::pow(1.98, 3));
}

TEST_CASE("make_polytope() equals repeated clip() of a box to the bit") {
  std::size_t most = 0;
  const auto check = [&](const facet::Convex& solid, const facet::PlaneTable& planes) {
    const convex::Polytope expected = clipped_one_by_one(solid, planes);
    const convex::Polytope found = convex::make_polytope(solid, planes);
    REQUIRE(found.vertices == expected.vertices);
    REQUIRE(found.faces.size() == expected.faces.size());
    for (std::size_t i = 0; i < found.faces.size(); ++i) {
      REQUIRE(found.faces[i].halfspace == expected.faces[i].halfspace);
      REQUIRE(found.faces[i].corners == expected.faces[i].corners);
    }
    most = std::max(most, found.faces.size());
  };
  testing::RandomPoints random(3);
  const auto check_all = [&](const facet::Geometry& scene) {
    for (facet::Convex solid : scene.solids) {
      check(solid, scene.planes);
      for (std::size_t i = solid.halfspaces.size(); i > 1; --i)
        std::swap(solid.halfspaces[i - 1], solid.halfspaces[random.below(i)]);
      check(solid, scene.planes);
    }
  };
  for (const std::string text : {"sphere($fn=40,$fa=12,$fs=2,r=20);", "cylinder($fn=300,$fa=12,$fs=2,h=7,r1=3,r2=3);",
                                 "cylinder($fn=200,$fa=12,$fs=2,h=7,r1=3,r2=0);"}) {
    CAPTURE(text);
    check_all(TestModel(turned + "{" + text + "}").scene);
  }
  const TestModel ball("sphere($fn=0,$fa=12,$fs=2,r=2);");
  check_all(facet::make_geometry(ball.tree, {0.02, std::nullopt}));
  const auto seeds = testing::cases<std::uint64_t>(100, 25);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    check_all(TestModel(testing::random_model(seed, 6)).scene);
  }
  CHECK(most > 700);
}

TEST_CASE("solids with thousands of half-spaces match clip() to rounding") {
  const auto check = [&](const facet::Convex& solid, const facet::Geometry& scene, const convex::Polytope& expected) {
    const facet::PlaneTable& planes = scene.planes;
    const convex::Polytope found = convex::make_polytope(solid, planes);
    CHECK(describe_flaws(scene, found) == "");
    REQUIRE(found.vertices.size() == expected.vertices.size());
    REQUIRE(found.faces.size() == expected.faces.size());
    CHECK(found.faces.size() > 1000);
    for (std::size_t i = 0; i < found.faces.size(); ++i) {
      REQUIRE(found.faces[i].halfspace == expected.faces[i].halfspace);
      REQUIRE(found.faces[i].corners.size() == expected.faces[i].corners.size());
      for (const std::uint32_t corner : found.faces[i].corners) {
        const auto is_near = [&](std::uint32_t other) {
          return glm::length(found.vertices[corner] - expected.vertices[other]) < 1e-9 * planes.diagonal();
        };
        REQUIRE(std::ranges::any_of(expected.faces[i].corners, is_near));
      }
    }
  };
  for (const std::string text :
       {"sphere($fn=52,$fa=12,$fs=2,r=20);", "cylinder($fn=1200,$fa=12,$fs=2,h=7,r1=3,r2=3);"}) {
    CAPTURE(text);
    const TestModel model(turned + "{" + text + "}");
    const facet::Convex& solid = model.scene.solids.front();
    check(solid, model.scene, clipped_one_by_one(solid, model.scene.planes));
  }
  // More half-spaces than are clipped in their original order.
  const TestModel many(turned + "{sphere($fn=150,$fa=12,$fs=2,r=20);}");
  const facet::Convex& round = many.scene.solids.front();
  CHECK(round.halfspaces.size() > 10'000);
  check(round, many.scene, carved_in_order(round, many.scene.planes));
  const TestModel ball("sphere($fn=0,$fa=12,$fs=2,r=2);");
  const facet::Geometry scene = facet::make_geometry(ball.tree, {0.005, std::nullopt});
  check(scene.solids.front(), scene, clipped_one_by_one(scene.solids.front(), scene.planes));
}

TEST_CASE("polytopes with planes near common corners match clip() to the bit") {
  testing::RandomPoints random(1999);
  std::size_t most = 0;
  const int rounds = testing::cases(200, 30);
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    facet::PlaneTable planes(glm::dvec3(0), 1.0);
    const double near = convex::tolerance(planes);
    facet::Convex solid;
    solid.box = {glm::dvec3(-0.25), glm::dvec3(0.25)};
    for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
      for (const double sign : {-1.0, 1.0}) solid.halfspaces.push_back(planes.add({sign * axis, -0.25}));
    }
    // Planes around points on a sphere: many pass through the same point, or nearly, and others only touch the sphere.
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back(0.25 * random.direction());
    for (int i = 0; i < 150; ++i) {
      const glm::dvec3 at = corners[random.below(corners.size())];
      // One random draw per statement, because the evaluation order within a statement is unspecified.
      const double turned_by = random.between(0, 0.3);
      const glm::dvec3 normal = glm::normalize(4.0 * at + turned_by * random.direction());
      const double steps = random.between(-2, 2);
      const double off = near * steps * static_cast<double>(random.below(2));
      solid.halfspaces.push_back(planes.add({normal, off - glm::dot(normal, at)}));
    }
    const convex::Polytope expected = clipped_one_by_one(solid, planes);
    const convex::Polytope found = convex::make_polytope(solid, planes);
    REQUIRE(found.vertices == expected.vertices);
    REQUIRE(found.faces.size() == expected.faces.size());
    for (std::size_t i = 0; i < found.faces.size(); ++i) REQUIRE(found.faces[i].corners == expected.faces[i].corners);
    CHECK(found.vertices.size() > 3);
    most = std::max(most, found.vertices.size());
  }
  CHECK(most > 64);
}

TEST_CASE("a plane cuts a polytope into two polytopes whose volumes add up") {
  int cuts = 0;
  const auto seeds = testing::cases<std::uint64_t>(300, 60);
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    const TestModel model(testing::random_model(seed, 6));
    if (model.solids.empty()) continue;
    const convex::Polytope whole = only_solid(model);
    for (std::uint32_t plane = 0; plane < model.scene.planes.planes().size(); ++plane) {
      const convex::Polytope below = convex::clip(whole, {plane, true}, model.scene.planes);
      const convex::Polytope above = convex::clip(whole, {plane, false}, model.scene.planes);
      REQUIRE(describe_flaws(model.scene, below) == "");
      REQUIRE(describe_flaws(model.scene, above) == "");
      const double sum = (below.empty() ? 0.0 : convex::volume(below)) + (above.empty() ? 0.0 : convex::volume(above));
      REQUIRE(sum == doctest::Approx(convex::volume(whole)).epsilon(1e-9));
      if (below.empty() || above.empty()) continue;
      ++cuts;
      // Merged again, they equal the original.
      std::vector<convex::Polytope> halves{below, above};
      convex::merge(halves, model.scene.planes);
      REQUIRE(halves.size() == 1);
      REQUIRE(halves.front().faces.size() == whole.faces.size());
      REQUIRE(describe_flaws(model.scene, halves.front()) == "");
    }
  }
  CHECK((!testing::draws_usual_cases() || cuts > 2000));
}

TEST_CASE("a plane through edges adds no edges and one that touches changes nothing") {
  const TestModel model(
      "union(){cube(size=[2,2,2],center=false);"
      "multmatrix([[0.7071067811865476,-0.7071067811865476,0,1],[0.7071067811865476,0.7071067811865476,0,-1],[0,0,1,0],"
      "[0,0,0,1]]){cube(size=[9,9,9],center=false);}}");
  const convex::Polytope cube = only_solid(model);
  // x + y >= 0 touches the cube along an edge, and y - x >= -2 along another.
  int touching = 0;
  for (const facet::Halfspace& halfspace : model.scene.solids[1].halfspaces) {
    const convex::Polytope in = convex::clip(cube, halfspace, model.scene.planes);
    const convex::Polytope out = convex::clip(cube, convex::opposite(halfspace), model.scene.planes);
    CHECK(in.empty() != out.empty());
    const convex::Polytope& kept = in.empty() ? out : in;
    CHECK(kept.faces.size() == 6);
    CHECK(kept.vertices == cube.vertices);
    ++touching;
  }
  CHECK(touching == 6);

  const TestModel wedge(
      "union(){cube(size=[2,2,2],center=false);polyhedron(points=[[0,0,-1],[0,0,3],[2,2,-1],[2,2,3],[2,0,-1],[2,0,3]],"
      "faces=[[0,1,3,2],[2,3,5,4],[4,5,1,0],[1,5,3],[0,2,4]],convexity=1);}");
  const convex::Polytope half =
      convex::clip(only_solid(wedge), wedge.scene.solids[1].halfspaces[0], wedge.scene.planes);
  CHECK(half.faces.size() == 5);
  CHECK(half.vertices.size() == 6);
  CHECK(convex::volume(half) == doctest::Approx(4.0));
}

TEST_CASE("a sheet thinner than the tolerance vanishes and a thicker one remains") {
  for (const double thickness : {0.3, 0.9, 1.1, 3.0}) {
    CAPTURE(thickness);
    // The diagonal of the scene is 10 sqrt(3), much larger than the diagonal of either box.
    const double size = thickness * convex::relative_tolerance * 10.0 * std::sqrt(3.0);
    const TestModel model(fmt::format(
        "union(){{cube(size=[1,1,1],center=false);multmatrix([[1,0,0,{:.17g}],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"
        "{{cube(size=[1,1,1],center=false);}}"
        "multmatrix([[1,0,0,9],[0,1,0,9],[0,0,1,9],[0,0,0,1]]){{cube(size=[1,1,1],center=false);}}}}",
        1.0 - size));
    convex::Polytope sheet = only_solid(model);
    for (const facet::Halfspace& halfspace : model.scene.solids[1].halfspaces) {
      sheet = convex::clip(std::move(sheet), halfspace, model.scene.planes);
    }
    CHECK(sheet.empty() == (thickness < 1.0));
    CHECK(describe_flaws(model.scene, sheet) == "");
  }
}

TEST_CASE("planes near common corners by about the tolerance yield valid polytopes") {
  testing::RandomPoints random(1987);
  int cuts = 0;
  for (int round = 0; round < 3000; ++round) {
    CAPTURE(round);
    // Planes near the corners of a cube of diagonal 1 and of what remains of it.
    facet::PlaneTable planes(glm::dvec3(0), 1.0);
    const double near = convex::tolerance(planes);
    facet::Convex solid;
    solid.box = {glm::dvec3(-0.25), glm::dvec3(0.25)};
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        glm::dvec3 normal(0);
        normal[axis] = sign;
        solid.halfspaces.push_back(planes.add({normal, -0.25}));
      }
    }
    facet::Geometry scene{{}, std::move(planes), {}};
    convex::Polytope polytope = convex::make_polytope(solid, scene.planes);
    for (int cut = 0; cut < 12; ++cut) {
      const auto corner = [&] { return polytope.vertices[random.below(polytope.vertices.size())]; };
      const glm::dvec3 a = corner();
      const glm::dvec3 b = corner();
      const glm::dvec3 c = corner();
      const glm::dvec3 across = glm::cross(b - a, c - a);
      const glm::dvec3 raw = glm::length(across) > 1e-6 ? glm::normalize(across) : random.direction();
      const glm::dvec3 normal = glm::normalize(raw + near * random.between(0, 4) * random.direction());
      const double offset = -glm::dot(normal, a) + near * random.between(-2, 2);
      const facet::Halfspace halfspace = scene.planes.add({normal, offset});
      convex::Polytope next = convex::clip(polytope, halfspace, scene.planes);
      if (next.empty()) next = convex::clip(polytope, convex::opposite(halfspace), scene.planes);
      if (next.empty()) break;
      if (next.vertices != polytope.vertices) ++cuts;
      polytope = std::move(next);
      // The tolerance may have been raised, but only by a limited amount.
      REQUIRE(describe_flaws(scene, polytope, 1.01) == "");
    }
  }
  CHECK(cuts > 5000);
}

TEST_CASE("an empty solid yields an empty polytope that stays empty when clipped") {
  facet::PlaneTable planes(glm::dvec3(0), 1.0);
  const facet::Halfspace halfspace = planes.add({{0, 0, 1}, 0});
  CHECK(convex::make_polytope({}, planes).empty());
  CHECK(convex::clip({}, halfspace, planes).empty());
}

TEST_CASE("clipping a polytope with a non-finite corner terminates") {
  const TestModel model("cube(size=[2,3,5],center=false);");
  const facet::Convex& solid = model.scene.solids.front();
  for (const double odd : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (const facet::Halfspace& halfspace : solid.halfspaces) {
      convex::Polytope polytope = only_solid(model);
      polytope.vertices.front() = glm::dvec3(odd);
      const convex::Polytope clipped = convex::clip(polytope, convex::opposite(halfspace), model.scene.planes);
      CHECK(clipped.vertices.size() <= 2 * polytope.vertices.size());
    }
  }
}
