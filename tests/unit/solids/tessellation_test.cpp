#include "host/solids/tessellation.h"

#include "places.h"
#include "tests/support/test.h"

using csgsim::solids::tessellate;

namespace {

/// A face as passed to polyhedron(), and the triangles that OpenSCAD made of it (openscad/make.py).
struct Cut {
  std::vector<glm::vec3> corners;
  std::set<std::set<std::uint32_t>> triangles;
};

std::vector<Cut> cuts() {
  std::ifstream file(std::string(CSGSIM_SOURCE_DIR) + "/tests/unit/solids/openscad/faces.txt");
  std::vector<Cut> all;
  for (std::string line; std::getline(file, line);) {
    Cut& cut = all.emplace_back();
    std::istringstream corners(line.substr(0, line.find('|')));
    for (glm::vec3 corner; corners >> corner.x >> corner.y >> corner.z;) cut.corners.push_back(corner);
    std::istringstream numbers(line.substr(line.find('|') + 1));
    for (std::uint32_t a = 0, b = 0, c = 0; numbers >> a >> b >> c;) cut.triangles.insert({a, b, c});
  }
  return all;
}

/// Whether the triangles agree; nothing if the face crosses itself in projection.
std::optional<bool> agrees(const Cut& cut) {
  // OpenSCAD reverses the faces of polyhedron().
  const std::vector<glm::vec3> outline(cut.corners.rbegin(), cut.corners.rend());
  const auto triangles = tessellate(outline);
  if (!triangles) return std::nullopt;
  std::set<std::set<std::uint32_t>> made;
  const auto last = static_cast<std::uint32_t>(outline.size() - 1);
  for (const auto& [a, b, c] : *triangles) made.insert({last - a, last - b, last - c});
  return made == cut.triangles;
}

}  // namespace

TEST_CASE("non-planar faces are cut into the same triangles as by OpenSCAD") {
  int crossed = 0;
  int others = 0;
  int alike = 0;
  for (const Cut& cut : cuts()) {
    const std::optional<bool> agree = agrees(cut);
    if (!agree) {
      ++crossed;
    } else if (cut.corners.size() == 4) {
      CHECK(*agree);
    } else {
      ++others;
      alike += *agree ? 1 : 0;
    }
  }
  CHECK(crossed == 5);
  CHECK(others == 195);
  // A face with reflex corners: diagonals may be flipped in another order.
  CHECK(alike >= 194);
}

TEST_CASE("triangles of a face keep its orientation and leave out a hole") {
  // A square with a square hole, joined to the outline by an edge run both ways.
  const std::vector<glm::vec3> outline{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                       {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  const auto triangles = tessellate(outline);
  REQUIRE(triangles);
  CHECK(triangles->size() == 8);
  float area = 0;
  for (const auto& [a, b, c] : *triangles) {
    const glm::vec3 normal = glm::cross(outline[b] - outline[a], outline[c] - outline[a]);
    CHECK(normal.z > 0);
    area += normal.z / 2;
  }
  CHECK(area == 12);
}

TEST_CASE("a triangle and a self-crossing face of five corners are not cut") {
  const std::vector<glm::vec3> bow{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {1, 2, 0}, {0, 2, 0}};
  CHECK(!tessellate(bow));
  CHECK(!tessellate(std::span(bow).first(3)));
}
