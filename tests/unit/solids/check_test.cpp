#include "host/solids/check.h"

#include "host/solids/limits.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using namespace solids;
using testing::box;

namespace {

constexpr double tolerance = solids::printed_tolerance;

std::string find_defect(const Mesh& mesh) {
  const auto checked = check(mesh, tolerance);
  return checked.defect ? checked.defect->what : "";
}

double volume_of(const Mesh& mesh) { return testing::volume_of(mesh.points, mesh.faces); }

}  // namespace

TEST_CASE("meshes from OpenSCAD have no defect and stay unchanged") {
  for (const char* name : {"gear", "letters", "cup", "bite", "twisted", "hollow"}) {
    CAPTURE(name);
    const Mesh mesh = testing::load_off(name);
    const auto checked = check(mesh, tolerance);
    CHECK(!checked.defect);
    CHECK(checked.mesh.faces.size() == mesh.faces.size());
    CHECK(volume_of(checked.mesh) == doctest::Approx(volume_of(mesh)).epsilon(1e-14));
  }
}

TEST_CASE("equal points of a mesh are merged and unused ones and collapsed faces dropped") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  Mesh apart;
  for (const auto& face : mesh.faces) {
    apart.points.emplace_back(7, 7, 7);
    auto& made = apart.faces.emplace_back();
    for (const std::uint32_t corner : face) {
      made.push_back(static_cast<std::uint32_t>(apart.points.size()));
      apart.points.push_back(mesh.points[corner]);
    }
  }
  apart.faces.push_back({1, 1, 2});
  const auto joined = solids::join_points(apart);
  CHECK(joined.mesh.points.size() == 8);
  CHECK(joined.mesh.faces.size() == 6);
  CHECK(joined.face_numbers == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  for (std::size_t i = 0; i < 8; ++i) CHECK(joined.mesh.points[i] == apart.points[joined.point_numbers[i]]);
  CHECK(find_defect(apart).empty());
}

TEST_CASE("an open mesh of one triangle or two is rejected") {
  const Mesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Mesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}};
  CHECK(find_defect(one) ==
        "the mesh is open: no other face has the edge of faces[0] from points[0] to points[1]; add one");
  CHECK(find_defect(two) ==
        "the mesh is open: no other face has the edge of faces[0] from points[0] to points[1]; add one");
}

TEST_CASE("the check of a mesh distinguishes a missing face from a reversed one") {
  const Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  Mesh open = mesh;
  open.faces.pop_back();
  CHECK(find_defect(open).starts_with("the mesh is open: no other face has the edge of faces["));
  CHECK(check(mesh, tolerance).turned.count == 0);
  // The solid is the box, whichever faces are turned.
  for (unsigned which = 1; which < 63; ++which) {
    Mesh wrong = mesh;
    for (std::size_t i = 0; i < 6; ++i) {
      if ((which >> i & 1U) != 0) std::ranges::reverse(wrong.faces[i]);
    }
    const auto checked = check(wrong, tolerance);
    CAPTURE(which);
    CHECK(!checked.defect);
    CHECK(checked.turned.count == std::min(std::popcount(which), 6 - std::popcount(which)));
    if (std::popcount(which) == 1) CHECK(checked.turned.first == std::countr_zero(which));
    CHECK(volume_of(checked.mesh) == doctest::Approx(1));
  }
}

TEST_CASE("a reversed box face is turned even if another box shares one of its edges") {
  Mesh boxes = box(glm::dvec3(0), glm::dvec3(1));
  testing::append(boxes, box(glm::dvec3(1, 1, 0), glm::dvec3(2, 2, 1)));
  for (std::size_t i = 0; i < 12; ++i) {
    Mesh wrong = boxes;
    std::ranges::reverse(wrong.faces[i]);
    const auto checked = check(wrong, tolerance);
    CAPTURE(i);
    CHECK(!checked.defect);
    CHECK(checked.turned.first == i);
    CHECK(volume_of(checked.mesh) == doctest::Approx(2));
  }
}

TEST_CASE("a one-sided surface is rejected as a mesh") {
  // Every other face of an octahedron and three squares through its middle: closed, with one side.
  const Mesh surface{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                     {{0, 1, 2}, {0, 4, 5}, {3, 1, 5}, {3, 4, 2}, {0, 1, 3, 4}, {1, 2, 4, 5}, {2, 0, 5, 3}}};
  CHECK(find_defect(surface).find(" both run from points[") != std::string::npos);
}

TEST_CASE("shells of a mesh are turned so that every other one faces inwards") {
  Mesh mesh;
  testing::append(mesh, box(glm::dvec3(0), glm::dvec3(9)));
  testing::append(mesh, box(glm::dvec3(1), glm::dvec3(8)));
  testing::append(mesh, box(glm::dvec3(2), glm::dvec3(7)));
  testing::append(mesh, box(glm::dvec3(20), glm::dvec3(21)));
  for (const bool reversed : {false, true}) {
    if (reversed) testing::reverse(mesh);
    const auto checked = check(mesh, tolerance);
    CHECK(!checked.defect);
    CHECK(volume_of(checked.mesh) == doctest::Approx(729 - 343 + 125 + 1).epsilon(1e-12));
  }
}

TEST_CASE("solids that overlap by more than the tolerance cross and touching ones do not") {
  Mesh touching = box(glm::dvec3(0), glm::dvec3(2));
  testing::append(touching, box(glm::dvec3(2, 0.5, 0.5), glm::dvec3(3)));
  CHECK(find_defect(touching) == "");
  Mesh crossing = box(glm::dvec3(0), glm::dvec3(2));
  testing::append(crossing, box(glm::dvec3(1.5, 0.5, 0.5), glm::dvec3(3)));
  CHECK(find_defect(crossing) == "");
  const auto found = check(crossing, tolerance).crossing;
  REQUIRE(found);
  CHECK(found->one < found->other);
  CHECK(found->depth == doctest::Approx(0.5));
  CHECK(found->count == 6);
  Mesh barely = box(glm::dvec3(0), glm::dvec3(2));
  testing::append(barely, box(glm::dvec3(2 - 1e-5, 0.5, 0.5), glm::dvec3(3)));
  CHECK(find_defect(barely) == "");
  CHECK(!check(barely, tolerance).crossing);
  const auto thin = check(barely, 1e-7).crossing;
  REQUIRE(thin);
  CHECK(thin->depth == doctest::Approx(1e-5).epsilon(1e-3));
}

TEST_CASE("a face folded through a shared corner crosses the others there") {
  // A pyramid whose tip is pulled down through its base.
  const auto pyramid = [](double tip) {
    return Mesh{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {3, 3, tip}, {1, 1, 1}},
                {{3, 2, 1, 0}, {0, 1, 5}, {2, 3, 5}, {3, 0, 5}, {1, 4, 5}, {4, 2, 5}, {1, 2, 4}}};
  };
  CHECK(find_defect(pyramid(0.5)).empty());
  CHECK(!check(pyramid(0.5), tolerance).crossing);
  CHECK(check(pyramid(-5), tolerance).crossing);
}

TEST_CASE("corners that lie on an unmatched edge of a mesh are inserted into its face") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  // The top is split into halves; the sides lack the new corners.
  const auto top = std::ranges::find_if(mesh.faces, [&](const auto& face) {
    return std::ranges::all_of(face, [&](std::uint32_t corner) { return mesh.points[corner].z == 1; });
  });
  const auto corners = *top;
  mesh.faces.erase(top);
  const auto base = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back((mesh.points[corners[0]] + mesh.points[corners[1]]) / 2.0);
  mesh.points.push_back((mesh.points[corners[2]] + mesh.points[corners[3]]) / 2.0);
  mesh.faces.push_back({corners[0], base, base + 1, corners[3]});
  mesh.faces.push_back({base, corners[1], corners[2], base + 1});
  CHECK(solids::find_open_edge(solids::join_points(mesh)));
  const auto checked = check(mesh, tolerance);
  CHECK(!checked.defect);
  CHECK(volume_of(checked.mesh) == doctest::Approx(1).epsilon(1e-14));
  // A corner off the edge leaves a gap.
  mesh.points[base].z = 0.9;
  CHECK(find_defect(mesh).starts_with("the mesh is open"));
}

TEST_CASE("an edge shared by four faces is accepted") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  testing::append(mesh, box(glm::dvec3(1, 1, 0), glm::dvec3(2, 2, 1)));
  CHECK(find_defect(mesh).empty());
}

TEST_CASE("points that rounding separates are joined only where the mesh is otherwise open") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  // A separate corner for one face, and a triangle without area attached to it.
  const std::uint32_t corner = mesh.faces[0][0];
  const auto moved = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(mesh.points[corner] + glm::dvec3(1e-5, 0, -1e-5));
  mesh.faces.push_back({corner, moved, mesh.faces[0][1]});
  mesh.faces[0][0] = moved;
  const auto checked = check(mesh, tolerance);
  CHECK(!checked.defect);
  CHECK(checked.mesh.faces.size() == 6);
  CHECK(volume_of(checked.mesh) == doctest::Approx(1).epsilon(1e-4));
  // The face with this corner is no longer flat and becomes two triangles; the one without area stays.
  CHECK(check(mesh, 1e-7).mesh.faces.size() == 8);
  mesh.faces.pop_back();
  CHECK(!check(mesh, tolerance).defect);
  CHECK(check(mesh, 1e-7).defect);
  // A closed mesh stays as it is, however close its points are.
  const Mesh thin = box(glm::dvec3(0), glm::dvec3(1, 1, 1e-5));
  CHECK(check(thin, tolerance).mesh.points.size() == 8);
}

TEST_CASE("a hole in a small solid is reported even if another solid has a far corner") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  mesh.faces.pop_back();
  testing::append(mesh, box(glm::dvec3(3), glm::dvec3(4)));
  mesh.points.back() = glm::dvec3(4e9, 4, 4);
  CHECK(find_defect(mesh).find("the mesh is open") != std::string::npos);
}

TEST_CASE("points far from the origin are joined only within the tolerance") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  mesh.faces.pop_back();
  for (glm::dvec3& point : mesh.points) point = point * 1e-8 + glm::dvec3(1e12, -1e12, 0);
  for (const double near : {1e-9, 1e-300, 0.0}) {
    solids::NumberedMesh numbered = solids::join_points(mesh);
    const auto points = numbered.mesh.points.size();
    solids::join_near_points(numbered, near);
    CHECK(numbered.mesh.points.size() == points);
  }
  // If doubles are coarser than the tolerance the next double is not near; elsewhere it is.
  mesh = box(glm::dvec3(1e12, 0, 0), glm::dvec3(1e12 + 1, 1, 1));
  const std::uint32_t corner = mesh.faces[0][0];
  mesh.faces[0][0] = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(mesh.points[corner]);
  mesh.points.back().x = std::nextafter(mesh.points[corner].x, 2e12);
  for (const auto& [near, count] : {std::pair(1e-5, 9), std::pair(1e-3, 8)}) {
    solids::NumberedMesh numbered = solids::join_points(mesh);
    solids::join_near_points(numbered, near);
    CHECK(numbered.mesh.points.size() == count);
  }
}

TEST_CASE("mesh coordinates whose squares overflow doubles are rejected") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1e12));
  CHECK(find_defect(mesh).empty());
  mesh.points[6].z = -1e300;
  CHECK(find_defect(mesh) == "points[6] has a coordinate beyond 1e+12; scale the solid down");
}

TEST_CASE("solids of a mesh that share a wall are merged") {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  testing::append(mesh, box(glm::dvec3(1, 0, 0), glm::dvec3(2, 1, 1)));
  const auto checked = check(mesh, tolerance);
  CHECK(!checked.defect);
  CHECK(checked.mesh.faces.size() == 10);
  CHECK(volume_of(checked.mesh) == doctest::Approx(2).epsilon(1e-14));
}
