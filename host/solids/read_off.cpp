#include <fmt/format.h>

#include <algorithm>

#include "host/solids/read_mesh.h"
#include "host/solids/words.h"

namespace csgsim::solids {

namespace {

// Minimum number of bytes of a point and a face: `0 0 0` and `3 0 1 2`, each with a line end.
constexpr std::size_t point_bytes = 6;
constexpr std::size_t face_bytes = 8;

std::uint32_t max_count(std::size_t bytes, std::size_t each) {
  return static_cast<std::uint32_t>(std::min((bytes + 1) / each, max_mesh_faces));
}

void read_header(Words& words) {
  const std::string_view kind = words.next();
  // After the coordinates of a point, these formats have colours, normals or texture coordinates, which are ignored.
  for (const std::string_view known : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"}) {
    if (kind == known) return;
  }
  words.fail("an OFF file must start with OFF; export it as OFF again");
}

}  // namespace

Mesh parse_off(std::string_view text, std::string_view name) {
  Words words(text, name, '#');
  read_header(words);
  const std::uint32_t points = words.count("the number of points", max_count(text.size(), point_bytes));
  const std::uint32_t faces = words.count("the number of faces", max_count(text.size(), face_bytes));
  words.next_on_line();  // number of edges: optional and often wrong
  Mesh mesh;
  mesh.points.resize(points);
  for (glm::dvec3& point : mesh.points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] = words.number("a coordinate");
    words.skip_line();
  }
  mesh.faces.resize(faces);
  for (auto& face : mesh.faces) {
    const std::uint32_t corners = words.count("the number of a face's corners", max_count(text.size(), 2));
    if (corners < 3) words.fail("a face needs at least 3 corners; complete or remove it");
    for (std::uint32_t k = 0; k < corners; ++k) {
      if (points == 0) words.fail("a face has corners, but there are no points; add them");
      face.push_back(words.count("the number of a point", points - 1));
    }
    words.skip_line();
  }
  return mesh;
}

}  // namespace csgsim::solids
