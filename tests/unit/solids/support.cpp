#include "tests/unit/solids/support.h"

#include "places.h"
#include "tests/support/test.h"

namespace csgsim::testing {

namespace {

using Long = glm::vec<3, long double>;

/// Whether a ray from the point crosses the triangle; empty if it passes too close to an edge or to the plane.
std::optional<bool> crosses(const Long& a, const Long& b, const Long& c, const Long& from, const Long& along) {
  const Long normal = glm::cross(b - a, c - a);
  const long double size = glm::length(normal);
  if (size == 0) return false;
  const long double slope = glm::dot(normal, along) / size;
  const long double height = glm::dot(normal, a - from) / size;
  constexpr long double near = 1e-9L;
  if (std::abs(slope) < near) return std::abs(height) < near ? std::nullopt : std::optional(false);
  const long double distance = height / slope;
  const Long at = from + distance * along;
  bool is_on_edge = false;
  const Long corners[] = {a, b, c};
  for (int i = 0; i < 3; ++i) {
    const Long edge = corners[(i + 1) % 3] - corners[i];
    const long double side = glm::dot(glm::cross(edge, at - corners[i]), normal) / (size * glm::length(edge));
    if (side < -near) return false;
    is_on_edge |= side < near;
  }
  if (std::abs(distance) < near) return std::nullopt;
  if (distance < 0) return false;
  if (is_on_edge) return std::nullopt;
  return true;
}

}  // namespace

solids::Mesh load_off(const std::string& name) {
  std::ifstream file(std::string(CSGSIM_SOURCE_DIR) + "/tests/models/solids/" + name + ".off");
  std::string word;
  std::size_t points = 0;
  std::size_t faces = 0;
  file >> word >> points >> faces >> word;
  solids::Mesh mesh;
  mesh.points.resize(points);
  for (glm::dvec3& point : mesh.points) file >> point.x >> point.y >> point.z;
  for (std::size_t i = 0; i < faces; ++i) {
    std::size_t count = 0;
    file >> count;
    std::vector<std::uint32_t>& face = mesh.faces.emplace_back(count);
    for (std::uint32_t& corner : face) file >> corner;
  }
  REQUIRE(file);
  return mesh;
}

solids::Mesh box(const glm::dvec3& low, const glm::dvec3& high) {
  solids::Mesh mesh;
  for (unsigned corner = 0; corner < 8; ++corner) {
    mesh.points.emplace_back((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                             (corner & 4U) != 0 ? high.z : low.z);
  }
  mesh.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return mesh;
}

void reverse(solids::Mesh& mesh) {
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
}

void append(solids::Mesh& mesh, const solids::Mesh& other) {
  const auto base = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (auto face : other.faces) {
    for (std::uint32_t& corner : face) corner += base;
    mesh.faces.push_back(std::move(face));
  }
}

Extent extent_of(std::span<const glm::dvec3> points) {
  Extent extent{points.front(), points.front()};
  for (const glm::dvec3& point : points) {
    extent.low = glm::min(extent.low, point);
    extent.high = glm::max(extent.high, point);
  }
  return extent;
}

double volume_of(std::span<const glm::dvec3> points, const std::vector<std::vector<std::uint32_t>>& faces) {
  const Extent extent = extent_of(points);
  const Long middle = Long(extent.low + extent.high) / 2.0L;
  long double six_times = 0;
  for (const auto& face : faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      six_times += glm::dot(Long(points[face[0]]) - middle,
                            glm::cross(Long(points[face[k]]) - middle, Long(points[face[k + 1]]) - middle));
    }
  }
  return static_cast<double>(six_times / 6);
}

double volume_of(std::span<const model::Polyhedron> pieces) {
  double sum = 0;
  for (const model::Polyhedron& piece : pieces) sum += volume_of(piece.points, piece.faces);
  return sum;
}

std::optional<bool> is_inside(const solids::Mesh& mesh, const glm::dvec3& point) {
  const Long along = glm::normalize(Long(0.5377L, 0.2113L, 0.8163L));
  bool inside = false;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const auto crossed = crosses(Long(mesh.points[face[0]]), Long(mesh.points[face[k]]),
                                   Long(mesh.points[face[k + 1]]), Long(point), along);
      if (!crossed) return std::nullopt;
      inside ^= *crossed;
    }
  }
  return inside;
}

std::optional<int> count_pieces_at(std::span<const model::Polyhedron> pieces, const glm::dvec3& point, double clear) {
  int count = 0;
  for (const model::Polyhedron& piece : pieces) {
    double highest = -1e300;
    for (const glm::dvec4& plane : piece.planes)
      highest = std::max(highest, glm::dot(glm::dvec3(plane), point) + plane.w);
    if (std::abs(highest) < clear) return std::nullopt;
    if (highest < 0) ++count;
  }
  return count;
}

glm::dvec3 random_point(std::mt19937_64& random, const Extent& extent) {
  std::uniform_real_distribution<double> part(-0.05, 1.05);
  const glm::dvec3 at(part(random), part(random), part(random));
  return extent.low + at * (extent.high - extent.low);
}

int check_pieces(const solids::Mesh& mesh, std::span<const model::Polyhedron> pieces, double loss) {
  const Extent extent = extent_of(mesh.points);
  const double size = glm::length(extent.high - extent.low);
  const double clear = (loss + 1e-9) * size;
  for (const model::Polyhedron& piece : pieces) {
    REQUIRE(piece.planes.size() == piece.faces.size());
    for (std::size_t i = 0; i < piece.faces.size(); ++i) {
      const glm::dvec3 normal(piece.planes[i]);
      REQUIRE(std::abs(glm::length(normal) - 1) < 1e-12);
      for (const glm::dvec3& point : piece.points) REQUIRE(glm::dot(normal, point) + piece.planes[i].w < clear);
      for (const std::uint32_t corner : piece.faces[i]) {
        REQUIRE(glm::dot(normal, piece.points[corner]) + piece.planes[i].w > -clear);
      }
    }
  }
  std::mt19937_64 random(7);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 point = random_point(random, extent);
    const std::optional<bool> expected = is_inside(mesh, point);
    const std::optional<int> count = count_pieces_at(pieces, point, clear);
    if (!expected || !count) continue;
    REQUIRE(*count == (*expected ? 1 : 0));
    if (*expected) ++inside;
  }
  const double volume = volume_of(mesh.points, mesh.faces);
  CHECK(std::abs(volume_of(pieces) - volume) <= (loss + 1e-9) * volume);
  return inside;
}

glm::dmat3 random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const glm::dvec3 x = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
  const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(normal(random), normal(random), normal(random))));
  return {x, y, glm::cross(x, y)};
}

}  // namespace csgsim::testing
