#include "host/solids/pieces.h"

#include <glm/vec2.hpp>

#include "host/solids/check.h"
#include "hw/base/work.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using namespace solids;
using namespace testing;

namespace {

/// Unit cubes on a grid, merged: only faces between a cube and empty space.
class Cubes {
 public:
  void add(std::array<int, 3> at) { cubes_[at] = true; }
  [[nodiscard]] std::size_t count() const { return cubes_.size(); }

  [[nodiscard]] Mesh mesh() const {
    Mesh made;
    std::map<std::array<int, 3>, std::uint32_t> places;
    for (const auto& [cube, there] : cubes_) {
      for (unsigned side = 0; side < 6; ++side) {
        const unsigned axis = side / 2;
        const int forward = side % 2 == 0 ? 1 : 0;
        std::array<int, 3> beyond = cube;
        beyond[axis] += forward == 1 ? 1 : -1;
        if (cubes_.contains(beyond)) continue;
        auto& face = made.faces.emplace_back();
        constexpr int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (unsigned k = 0; k < 4; ++k) {
          std::array<int, 3> corner = cube;
          const unsigned turn = forward == 1 ? k : 3 - k;
          corner[axis] += forward;
          corner[(axis + 1) % 3] += around[turn][0];
          corner[(axis + 2) % 3] += around[turn][1];
          const auto [place, is_new] = places.try_emplace(corner, static_cast<std::uint32_t>(made.points.size()));
          if (is_new) made.points.emplace_back(corner[0], corner[1], corner[2]);
          face.push_back(place->second);
        }
      }
    }
    return made;
  }

 private:
  std::map<std::array<int, 3>, bool> cubes_;
};

/// A prism of many sides, each face cut into triangles.
Mesh prism(std::uint32_t count) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.points.emplace_back(std::cos(angle), std::sin(angle), 1);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.faces.push_back({2 * i, 2 * next, 2 * next + 1});
    mesh.faces.push_back({2 * i, 2 * next + 1, 2 * i + 1});
    if (i < 2) continue;
    mesh.faces.push_back({0, 2 * i, 2 * (i - 1)});
    mesh.faces.push_back({1, 2 * (i - 1) + 1, 2 * i + 1});
  }
  return mesh;
}

Mesh in_single_precision(Mesh mesh, const glm::dmat3& turn) {
  for (glm::dvec3& point : mesh.points) point = glm::dvec3(glm::vec3(turn * point));
  return mesh;
}

}  // namespace

TEST_CASE("a mesh without faces has no pieces") { CHECK(convex_pieces({}).empty()); }

TEST_CASE("a convex mesh is one piece with coplanar triangles merged") {
  for (const std::uint32_t count : {3U, 7U, 500U}) {
    const Mesh mesh = prism(count);
    const auto pieces = convex_pieces(mesh);
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].faces.size() == count + 2);
    CHECK(pieces[0].points.size() == 2 * count);
    CHECK(testing::check_pieces(mesh, pieces, 0) > 100);
  }
}

TEST_CASE("an L-shaped mesh is two boxes with identical numbers for their common wall") {
  Cubes cubes;
  cubes.add({0, 0, 0});
  cubes.add({1, 0, 0});
  cubes.add({0, 1, 0});
  const Mesh mesh = cubes.mesh();
  const auto pieces = convex_pieces(mesh);
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].faces.size() == 6);
  CHECK(pieces[1].faces.size() == 6);
  int walls = 0;
  for (const glm::dvec4& plane : pieces[0].planes) {
    for (const glm::dvec4& other : pieces[1].planes) walls += plane == -other ? 1 : 0;
  }
  CHECK(walls == 1);
  CHECK(testing::check_pieces(mesh, pieces, 0) > 100);
}

TEST_CASE("meshes from OpenSCAD are split into pieces that cover them once") {
  // Coordinates of 6 digits bend faces: the volume error is the rounding times the surface.
  struct Case {
    std::string name;
    std::size_t max_pieces;  ///< in the first four rows, the number that CGAL's convex_decomposition_3 yields
  };
  for (const auto& known : {Case{"gear", 38}, Case{"letters", 104}, Case{"cup", 178}, Case{"bite", 395},
                            Case{"twisted", 100}, Case{"hollow", 80}}) {
    CAPTURE(known.name);
    const Mesh mesh = testing::load_off(known.name);
    const auto pieces = convex_pieces(mesh);
    CHECK(pieces.size() <= known.max_pieces);
    CHECK(testing::check_pieces(mesh, pieces, 2e-6) > 50);
  }
}

TEST_CASE("random rotated heaps of cubes are split into pieces of the same total volume") {
  std::mt19937_64 random(3);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    Cubes cubes;
    std::uniform_int_distribution<int> place(0, 3);
    for (int i = 0; i < 20; ++i) cubes.add({place(random), place(random), place(random)});
    Mesh mesh = cubes.mesh();
    const glm::dmat3 turn = round % 2 == 0 ? glm::dmat3(1) : testing::random_rotation(random);
    for (glm::dvec3& point : mesh.points) point = turn * point;
    solids::Limits limits;
    limits.tolerance = solids::double_precision_tolerance;
    const auto pieces = convex_pieces(mesh, limits);
    CHECK(pieces.size() <= cubes.count());
    CHECK(std::abs(testing::volume_of(pieces) - static_cast<double>(cubes.count())) < 1e-9);
    CHECK(testing::check_pieces(mesh, pieces, 0) > 50);
  }
}

namespace {

/// A prism between z = 0 and 1 over a face of any shape in the x, y plane.
Mesh extruded(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& face) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(points.size());
  for (const double z : {0.0, 1.0}) {
    for (const glm::dvec2& point : points) mesh.points.emplace_back(point, z);
  }
  auto& top = mesh.faces.emplace_back(face);
  for (std::uint32_t& corner : top) corner += count;
  mesh.faces.emplace_back(face.rbegin(), face.rend());
  const auto runs_back = [&](std::uint32_t from, std::uint32_t to) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (face[k] == to && face[(k + 1) % face.size()] == from) return true;
    }
    return false;
  };
  for (std::size_t k = 0; k < face.size(); ++k) {
    const std::uint32_t from = face[k];
    const std::uint32_t to = face[(k + 1) % face.size()];
    if (!runs_back(from, to)) mesh.faces.push_back({from, to, to + count, from + count});
  }
  return mesh;
}

}  // namespace

TEST_CASE("an L is split into two pieces and a star of five points into four to six") {
  const Mesh mesh = extruded({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {0, 1, 2, 3, 4, 5});
  const auto pieces = convex_pieces(mesh);
  CHECK(pieces.size() == 2);
  CHECK(testing::volume_of(pieces) == doctest::Approx(5).epsilon(1e-12));
  // A star of five points has five reflex corners, at most two of them per cut: three cuts.
  std::vector<glm::dvec2> star;
  std::vector<std::uint32_t> around;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi * i / 5;
    star.push_back((i % 2 == 0 ? 3.0 : 1.0) * glm::dvec2(std::cos(angle), std::sin(angle)));
    around.push_back(i);
  }
  const auto points = convex_pieces(extruded(star, around));
  CHECK(points.size() >= 4);
  CHECK(points.size() <= 6);
  CHECK(testing::volume_of(points) == doctest::Approx(5 * 3 * std::sin(std::numbers::pi / 5)).epsilon(1e-9));
}

TEST_CASE("a hole may be joined to its face's outline by an edge run both ways") {
  const Mesh mesh =
      extruded({{0, 0}, {5, 0}, {5, 5}, {0, 5}, {1, 1}, {1, 3}, {3, 3}, {3, 1}}, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4});
  const auto pieces = convex_pieces(mesh);
  CHECK(pieces.size() == 4);
  CHECK(testing::volume_of(pieces) == doctest::Approx(25 - 4).epsilon(1e-12));
}

TEST_CASE("a shell within a shell is a void and one in the void is a solid") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(9));
  Mesh hole = box(glm::dvec3(1), glm::dvec3(8));
  reverse(hole);
  append(mesh, hole);
  append(mesh, box(glm::dvec3(2), glm::dvec3(7)));
  append(mesh, box(glm::dvec3(20), glm::dvec3(21)));
  const auto pieces = convex_pieces(mesh);
  CHECK(pieces.size() == 8);
  CHECK(testing::volume_of(pieces) == doctest::Approx(9 * 9 * 9 - 7 * 7 * 7 + 5 * 5 * 5 + 1).epsilon(1e-12));
  CHECK(testing::check_pieces(mesh, pieces, 0) > 10);
}

TEST_CASE("faces bent by single precision yield at most four pieces more than flat ones") {
  const Mesh mesh = testing::load_off("gear");
  std::mt19937_64 random(5);
  const std::size_t flat = convex_pieces(mesh).size();
  for (int round = 0; round < 10; ++round) {
    const Mesh bent = in_single_precision(mesh, testing::random_rotation(random));
    const auto pieces = convex_pieces(bent);
    CHECK(pieces.size() <= flat + 4);
    CHECK(testing::check_pieces(bent, pieces, 2e-6) > 50);
  }
}

TEST_CASE("a face bent by more than rounding is cut into triangles") {
  // The top of a cube with one corner lower by half: a ridge or a valley.
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  for (glm::dvec3& point : mesh.points) {
    if (point == glm::dvec3(1, 1, 1)) point.z = 0.5;
  }
  const auto pieces = convex_pieces(mesh);
  const double volume = testing::volume_of(pieces);
  CHECK((std::abs(volume - 5.0 / 6) < 1e-12 || std::abs(volume - 11.0 / 12) < 1e-12));
}

TEST_CASE("pieces cover a spring whose turns nearly touch and have six-digit coordinates") {
  constexpr std::uint32_t sides = 8;
  constexpr std::uint32_t steps = 40;  // a turn takes 16
  Mesh mesh;
  const auto printed = [](double value) { return std::stod(fmt::format("{:.6g}", value)); };
  for (std::uint32_t step = 0; step <= steps; ++step) {
    const double turn = step * std::numbers::pi / 8;
    for (std::uint32_t side = 0; side < sides; ++side) {
      const double around = (side + 0.5) * 2 * std::numbers::pi / sides;
      const double radius = 2.5 + 0.25 * std::cos(around);
      mesh.points.push_back({printed(radius * std::cos(turn)), printed(radius * std::sin(turn)),
                             printed(0.48 * turn / (2 * std::numbers::pi) + 0.25 * std::sin(around))});
    }
  }
  const auto corner = [](std::uint32_t step, std::uint32_t side) { return step * sides + side % sides; };
  for (std::uint32_t step = 0; step < steps; ++step) {
    for (std::uint32_t side = 0; side < sides; ++side) {
      mesh.faces.push_back({corner(step, side), corner(step + 1, side), corner(step + 1, side + 1)});
      mesh.faces.push_back({corner(step, side), corner(step + 1, side + 1), corner(step, side + 1)});
    }
  }
  mesh.faces.push_back({0, 1, 2, 3, 4, 5, 6, 7});
  auto& end = mesh.faces.emplace_back();
  for (std::uint32_t side = sides; side-- > 0;) end.push_back(corner(steps, side));
  const solids::CheckedMesh checked = solids::check(mesh, solids::printed_tolerance);
  CHECK(checked.defect.value_or(solids::Defect{}).what.empty());
  CHECK(testing::check_pieces(checked.mesh, convex_pieces(checked.mesh), 1e-4) > 5);
}

TEST_CASE("splitting an open or inverted mesh into pieces is an error") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  reverse(mesh);
  CHECK(testing::error_of([&] { convex_pieces(mesh); }) ==
        "a shell faces inwards and is inside no other shell; reverse its faces");
  Cubes cubes;
  cubes.add({0, 0, 0});
  cubes.add({1, 0, 0});
  cubes.add({0, 1, 0});
  mesh = cubes.mesh();
  mesh.faces.erase(mesh.faces.begin());
  CHECK(testing::error_of([&] { convex_pieces(mesh); }) == "the solid's surface has a hole; close it");
}

TEST_CASE("more pieces or parts of faces than the limits allow are rejected") {
  const Mesh mesh = testing::load_off("gear");
  solids::Limits limits;
  limits.max_pieces = 10;
  CHECK(testing::error_of([&] { convex_pieces(mesh, limits); }) ==
        "the solid needs more than 10 convex pieces; use fewer faces, or divide the solid");
  limits = {};
  limits.max_fragments = 100;
  CHECK(testing::error_of([&] { convex_pieces(mesh, limits); }) ==
        "the solid's faces are cut into more than 100 parts; use fewer faces, or divide the solid");
}

TEST_CASE("gathering the faces of a mesh by planes counts as work") {
  const Mesh mesh = testing::load_off("gear");
  solids::Limits limits;
  // Gathering takes at least one step per face.
  limits.work = Work(mesh.faces.size());
  CHECK(testing::error_of([&] { convex_pieces(mesh, limits); }).starts_with("gathering the faces of a plane needs"));
}