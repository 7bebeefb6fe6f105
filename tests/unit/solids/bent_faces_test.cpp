#include <glm/gtc/matrix_transform.hpp>

#include "host/solids/check.h"
#include "host/solids/convex_faces.h"
#include "host/solids/limits.h"
#include "tests/support/test.h"
#include "tests/unit/solids/support.h"

using namespace csgsim;
using namespace solids;
using testing::box;

namespace {

using Corners = std::set<std::uint32_t>;

/// A box with a bent top: two opposite corners of it are lifted.
Mesh bent_box(double lift) {
  Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
  for (glm::dvec3& point : mesh.points) {
    if (point.z == 1 && point.x == point.y) point.z += lift;
  }
  return mesh;
}

std::set<Corners> triangles_of(const Mesh& mesh) {
  std::set<Corners> all;
  for (const auto& face : mesh.faces) {
    if (face.size() == 3) all.insert(Corners(face.begin(), face.end()));
  }
  return all;
}

}  // namespace

TEST_CASE("a bent face of a mesh is reported with its corners' deviation") {
  const auto checked = check(bent_box(0.2), solids::printed_tolerance);
  REQUIRE(!checked.defect);
  CHECK(checked.bent.count == 1);
  CHECK(checked.bent.max_deviation == doctest::Approx(0.1).epsilon(0.02));
  CHECK(triangles_of(checked.mesh).size() == 2);
  CHECK(checked.mesh.faces.size() == 7);
  CHECK(check(bent_box(1e-6), solids::printed_tolerance).bent.count == 0);
}

TEST_CASE("the diagonal that splits a bent square depends on the orientation") {
  const Mesh mesh = bent_box(0.2);
  std::set<std::set<Corners>> ways;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(90.0 * quarter), glm::dvec3(0, 0, 1));
    ways.insert(triangles_of(check(mesh, solids::printed_tolerance, {.transform = turn}).mesh));
  }
  CHECK(ways.size() == 2);
}

TEST_CASE("is_nearly_convex() accepts dents below 0.1 degrees and rejects two shells") {
  const auto dented = [](double depth) {
    Mesh mesh = box(glm::dvec3(0), glm::dvec3(1));
    const auto middle = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(0.5, 0.5, 1 - depth);
    const auto top = std::ranges::find_if(mesh.faces, [&](const auto& face) {
      return std::ranges::all_of(face, [&](std::uint32_t corner) { return mesh.points[corner].z == 1; });
    });
    const auto corners = *top;
    mesh.faces.erase(top);
    for (std::size_t i = 0; i < 4; ++i) mesh.faces.push_back({corners[i], corners[(i + 1) % 4], middle});
    return mesh;
  };
  CHECK(solids::is_nearly_convex(dented(-0.3)));
  CHECK(solids::is_nearly_convex(dented(0.0005)));
  CHECK(!solids::is_nearly_convex(dented(0.001)));
  Mesh two = box(glm::dvec3(0), glm::dvec3(1));
  testing::append(two, box(glm::dvec3(2), glm::dvec3(3)));
  CHECK(!solids::is_nearly_convex(two));
}
