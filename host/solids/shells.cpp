#include "host/solids/shells.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "host/solids/neighbours.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

/// Calls visit(a, b, c) for the triangles that fan out from the first corner of each face.
template <class Visit>
void for_each_triangle(const Mesh& mesh, std::span<const std::uint32_t> faces, const Visit& visit) {
  for (const std::uint32_t i : faces) {
    const std::vector<std::uint32_t>& face = mesh.faces[i];
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      visit(mesh.points[face[0]], mesh.points[face[k]], mesh.points[face[k + 1]]);
    }
  }
}

bool contains(const facet::Box& outer, const facet::Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) && glm::all(glm::lessThanEqual(inner.high, outer.high));
}

constexpr std::string_view nesting = "finding the nesting of a mesh's shells";

/// Cost of one face in a winding number, in steps of work.
constexpr std::uint64_t angle_steps = 50;

/// Whether one shell is inside another. The centre of the first face that is not close to the other shell decides.
bool is_within(const Mesh& mesh, const FaceList& inner, const FaceList& outer, const Work& work) {
  double sum = 0;
  for (const std::uint32_t face : inner) {
    glm::dvec3 middle(0);
    for (const std::uint32_t corner : mesh.faces[face]) {
      middle += mesh.points[corner] / static_cast<double>(mesh.faces[face].size());
    }
    work.charge(angle_steps * outer.size(), nesting);
    sum = winding(mesh, outer, middle);
    constexpr double clear = 0.25;
    if (std::abs(std::abs(sum) - 0.5) > clear) break;
  }
  return std::abs(sum) > 0.5;
}

}  // namespace

facet::Box box_of(const Mesh& mesh, std::span<const std::uint32_t> faces) {
  facet::Box box;
  for (const std::uint32_t face : faces) {
    for (const std::uint32_t corner : mesh.faces[face]) box = facet::hull(box, mesh.points[corner]);
  }
  return box;
}

double six_times_volume(const Mesh& mesh, std::span<const std::uint32_t> faces) {
  if (faces.empty()) return 0;
  const glm::dvec3 apex = mesh.points[mesh.faces[faces[0]][0]];
  double sum = 0;
  for_each_triangle(mesh, faces, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    sum += glm::dot(a - apex, glm::cross(b - apex, c - apex));
  });
  return sum;
}

double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), below);
}

double winding(const Mesh& mesh, std::span<const std::uint32_t> faces, const glm::dvec3& point) {
  double angles = 0;
  for_each_triangle(mesh, faces, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    angles += solid_angle(a - point, b - point, c - point);
  });
  return angles / (4.0 * std::numbers::pi);
}

std::vector<FaceList> collect_shells(const Mesh& mesh) {
  const std::vector<std::uint32_t> shells = find_shells(mesh);
  std::vector<FaceList> faces;
  for (std::uint32_t face = 0; face < shells.size(); ++face) {
    if (shells[face] == faces.size()) faces.emplace_back();
    faces[shells[face]].push_back(face);
  }
  return faces;
}

std::vector<std::uint32_t> nesting_depths(const Mesh& mesh, const std::vector<FaceList>& shells, const Work& work) {
  std::vector<facet::Box> boxes;
  boxes.reserve(shells.size());
  for (const FaceList& shell : shells) boxes.push_back(box_of(mesh, shell));
  std::vector<std::uint32_t> depths(shells.size(), 0);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    work.charge(shells.size(), nesting);
    for (std::size_t other = 0; other < shells.size(); ++other) {
      if (other != i && contains(boxes[other], boxes[i]) && is_within(mesh, shells[i], shells[other], work))
        ++depths[i];
    }
  }
  return depths;
}

std::vector<FaceList> collect_solids(const Mesh& mesh, const Work& work) {
  const std::vector<FaceList> shells = collect_shells(mesh);
  std::vector<double> volumes;
  std::vector<facet::Box> boxes;
  for (const FaceList& shell : shells) {
    volumes.push_back(six_times_volume(mesh, shell));
    boxes.push_back(box_of(mesh, shell));
  }
  std::vector<FaceList> solids;
  std::vector<std::size_t> solid_index(shells.size(), 0);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (volumes[i] < 0) continue;
    solid_index[i] = solids.size();
    solids.push_back(shells[i]);
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (volumes[i] >= 0) continue;
    std::size_t least = shells.size();
    work.charge(shells.size(), nesting);
    for (std::size_t other = 0; other < shells.size(); ++other) {
      if (volumes[other] < -volumes[i] || !contains(boxes[other], boxes[i])) continue;
      if (least < shells.size() && volumes[least] <= volumes[other]) continue;
      if (is_within(mesh, shells[i], shells[other], work)) least = other;
    }
    if (least == shells.size())
      throw InputError("a shell faces inwards and is inside no other shell; reverse its faces");
    FaceList& solid = solids[solid_index[least]];
    solid.insert(solid.end(), shells[i].begin(), shells[i].end());
  }
  return solids;
}

}  // namespace csgsim::solids
