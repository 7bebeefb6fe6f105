#include "host/read/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace csgsim::read {

namespace {

constexpr std::uint32_t unused = 0xffffffffU;

/// For each point the index of the first one equal to it.
std::vector<std::uint32_t> first_equals(const std::vector<glm::dvec3>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::ranges::sort(order,
                    [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Drops corners that repeat the one before them, around the end too.
void drop_repeats(Face& face) {
  face.erase(std::unique(face.begin(), face.end()), face.end());
  while (face.size() > 1 && face.front() == face.back()) face.pop_back();
}

struct Edge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;

  [[nodiscard]] auto ends() const { return std::pair(from, to); }
};

std::vector<Edge> sorted_edges(const Mesh& mesh) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& face = mesh.faces[i];
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges.push_back({face[k], face[(k + 1) % face.size()], static_cast<std::uint32_t>(i)});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& edge) { return std::tuple(edge.from, edge.to, edge.face); });
  return edges;
}

}  // namespace

Mesh make_mesh(const std::vector<glm::dvec3>& points, const std::vector<Face>& faces) {
  const std::vector<std::uint32_t> first = first_equals(points);
  std::vector<std::uint32_t> index(points.size(), unused);
  Mesh mesh;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Face face = faces[i];
    for (std::uint32_t& corner : face) corner = first[corner];
    drop_repeats(face);
    if (face.size() < 3) continue;
    for (std::uint32_t& corner : face) {
      if (index[corner] == unused) {
        index[corner] = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back(points[corner]);
        mesh.point_numbers.push_back(corner);
      }
      corner = index[corner];
    }
    mesh.faces.push_back(std::move(face));
    mesh.face_numbers.push_back(static_cast<std::uint32_t>(i));
  }
  return mesh;
}

std::optional<Defect> find_open_edge(const Mesh& mesh) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  const auto point = [&](std::uint32_t i) { return mesh.point_numbers[i]; };
  const auto face = [&](const Edge& edge) { return mesh.face_numbers[edge.face]; };
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Edge& edge = edges[i];
    if (edge.ends() != edges[i - 1].ends()) continue;
    return Defect{face(edge), fmt::format("faces[{}] and faces[{}] both run from points[{}] to points[{}]; reverse one",
                                          face(edges[i - 1]), face(edge), point(edge.from), point(edge.to))};
  }
  for (const Edge& edge : edges) {
    if (std::ranges::binary_search(edges, std::pair(edge.to, edge.from), {}, &Edge::ends)) continue;
    return Defect{face(edge), fmt::format("the polyhedron is open: no face joins faces[{}] from points[{}] to "
                                          "points[{}]; add one",
                                          face(edge), point(edge.from), point(edge.to))};
  }
  return std::nullopt;
}

}  // namespace csgsim::read
