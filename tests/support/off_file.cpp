#include "tests/support/off_file.h"

#include <cstddef>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace csgsim::testing {

Mesh read_off(const std::string& path) {
  std::ifstream file(path);
  std::string magic;
  std::size_t point_count = 0;
  std::size_t face_count = 0;
  std::size_t edge_count = 0;
  file >> magic >> point_count >> face_count >> edge_count;
  Mesh mesh;
  mesh.points.resize(point_count);
  for (glm::dvec3& p : mesh.points) file >> p.x >> p.y >> p.z;
  mesh.faces.resize(face_count);
  for (std::vector<unsigned>& face : mesh.faces) {
    std::size_t corners = 0;
    file >> corners;
    face.resize(corners);
    for (unsigned& corner : face) file >> corner;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  if (!file || magic != "OFF") throw std::runtime_error(path + " is not an OFF file");
  return mesh;
}

}  // namespace csgsim::testing
