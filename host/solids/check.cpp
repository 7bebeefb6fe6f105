#include "host/solids/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "host/facet/geometry.h"
#include "host/solids/flat_faces.h"
#include "host/solids/limits.h"
#include "host/solids/neighbours.h"
#include "host/solids/shells.h"

namespace csgsim::solids {

namespace {

using Face = std::vector<std::uint32_t>;

/// Maps each point to the first point equal to it.
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

/// Drops corners that equal the previous corner; the first corner follows the last.
void drop_repeats(Face& face) {
  face.erase(std::unique(face.begin(), face.end()), face.end());
  while (face.size() > 1 && face.front() == face.back()) face.pop_back();
}

/// Rotates the corners so that the smallest index comes first.
Face rotated(Face face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

Face reversed(Face face) {
  std::reverse(face.begin(), face.end());
  return rotated(std::move(face));
}

/// Marks pairs of faces with the same corners in opposite order, which cancel each other.
std::vector<bool> cancelled(const std::vector<Face>& faces) {
  std::vector<std::pair<Face, std::uint32_t>> by_corners;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (faces[i].size() < 3) continue;
    Face corners = faces[i];
    std::sort(corners.begin(), corners.end());
    by_corners.emplace_back(std::move(corners), i);
  }
  std::sort(by_corners.begin(), by_corners.end());
  std::vector<bool> gone(faces.size());
  const auto is_opposite = [&](std::uint32_t one, std::uint32_t other) {
    return !gone[one] && !gone[other] && rotated(faces[one]) == reversed(faces[other]);
  };
  for (std::size_t i = 0; i < by_corners.size(); ++i) {
    for (std::size_t k = i + 1; k < by_corners.size() && by_corners[k].first == by_corners[i].first; ++k) {
      if (!is_opposite(by_corners[i].second, by_corners[k].second)) continue;
      gone[by_corners[i].second] = gone[by_corners[k].second] = true;
    }
  }
  return gone;
}

/// The median length of the faces' edges. A shared edge counts once for each face. 0 if there are no edges.
double median_edge(const Mesh& mesh) {
  std::vector<double> lengths;
  for (const Face& face : mesh.faces) {
    for (std::size_t k = 0; k < face.size(); ++k)
      lengths.push_back(glm::distance(mesh.points[face[k]], mesh.points[face[(k + 1) % face.size()]]));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

std::string open_edge(const NumberedMesh& numbered, const EdgeSide& side) {
  const auto [from, to] = side.forward ? std::pair(side.low, side.high) : std::pair(side.high, side.low);
  return fmt::format("the mesh is open: no other face has the edge of faces[{}] from points[{}] to points[{}]; add one",
                     numbered.face_numbers[side.face], numbered.point_numbers[from], numbered.point_numbers[to]);
}

std::string same_way(const NumberedMesh& numbered, const EdgeSide& one, const EdgeSide& other) {
  const auto [from, to] = one.forward ? std::pair(one.low, one.high) : std::pair(one.high, one.low);
  return fmt::format("faces[{}] and faces[{}] both run from points[{}] to points[{}]; reverse one",
                     numbered.face_numbers[one.face], numbered.face_numbers[other.face], numbered.point_numbers[from],
                     numbered.point_numbers[to]);
}

}  // namespace

NumberedMesh join_points(const Mesh& mesh) {
  const std::vector<std::uint32_t> first = first_equals(mesh.points);
  std::vector<Face> faces = mesh.faces;
  for (Face& face : faces) {
    for (std::uint32_t& corner : face) corner = first[corner];
    drop_repeats(face);
  }
  const std::vector<bool> gone = cancelled(faces);
  std::vector<std::uint32_t> index(mesh.points.size(), none);
  NumberedMesh made;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    Face& face = faces[i];
    if (face.size() < 3 || gone[i]) continue;
    for (std::uint32_t& corner : face) {
      if (index[corner] == none) {
        index[corner] = static_cast<std::uint32_t>(made.mesh.points.size());
        made.mesh.points.push_back(mesh.points[corner]);
        made.point_numbers.push_back(corner);
      }
      corner = index[corner];
    }
    made.mesh.faces.push_back(std::move(face));
    made.face_numbers.push_back(i);
  }
  return made;
}

std::optional<Defect> find_far_point(const NumberedMesh& numbered) {
  const Mesh& mesh = numbered.mesh;
  const auto is_far = [&](std::uint32_t corner) {
    const glm::dvec3 size = glm::abs(mesh.points[corner]);
    return std::max({size.x, size.y, size.z}) > max_coordinate;
  };
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    const auto corner = std::ranges::find_if(mesh.faces[i], is_far);
    if (corner == mesh.faces[i].end()) continue;
    return Defect{numbered.face_numbers[i], fmt::format("points[{}] has a coordinate beyond {:g}; scale the solid down",
                                                        numbered.point_numbers[*corner], max_coordinate)};
  }
  return std::nullopt;
}

std::optional<Defect> find_open_edge(const NumberedMesh& numbered) {
  std::optional<Defect> found;
  for_each_edge(sorted_sides(numbered.mesh), [&](auto begin, auto end) {
    const auto forward = std::count_if(begin, end, [](const EdgeSide& side) { return side.forward; });
    const auto backward = end - begin - forward;
    if (found || forward == backward) return;
    std::vector<EdgeSide> most;
    std::copy_if(begin, end, std::back_inserter(most),
                 [&](const EdgeSide& side) { return side.forward == (forward > backward); });
    if (end - begin == 1) found = Defect{numbered.face_numbers[most[0].face], open_edge(numbered, most[0])};
    if (most.size() > 1) found = Defect{numbered.face_numbers[most[1].face], same_way(numbered, most[0], most[1])};
  });
  return found;
}

void turn_shells(Mesh& mesh) {
  const std::vector<FaceList> shells = collect_shells(mesh);
  const std::vector<std::uint32_t> depths = nesting_depths(mesh, shells);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    const bool faces_out = six_times_volume(mesh, shells[i]) >= 0;
    if (faces_out == (depths[i] % 2 == 0)) continue;
    for (const std::uint32_t face : shells[i]) std::ranges::reverse(mesh.faces[face]);
  }
}

CheckedMesh check(const Mesh& mesh, double tolerance, const MeshPlacement& placement) {
  NumberedMesh numbered = join_points(mesh);
  if (std::optional<Defect> defect = find_far_point(numbered)) return {std::move(numbered.mesh), std::move(defect)};
  CheckedMesh checked;
  const double rounding = tolerance * largest_coordinate(numbered.mesh);
  checked.bent = cut_bent_faces(
      numbered, std::min(rounding, max_tolerance * facet::box_of(numbered.mesh.points).diagonal()), placement);
  const double distance = std::min(rounding, max_edge_fraction * median_edge(numbered.mesh));
  join_near_points(numbered, distance);
  join_edges(numbered, distance);
  checked.defect = find_open_edge(numbered);
  if (checked.defect) {
    checked.turned = turn_faces(numbered);
    if (checked.turned.count > 0) checked.defect = find_open_edge(numbered);
  }
  if (!checked.defect) checked.crossing = find_crossing(numbered, distance);
  if (!checked.defect && !checked.crossing) turn_shells(numbered.mesh);
  checked.mesh = std::move(numbered.mesh);
  return checked;
}

}  // namespace csgsim::solids
