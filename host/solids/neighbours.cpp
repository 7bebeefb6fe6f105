#include "host/solids/neighbours.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace csgsim::solids {

namespace {

std::uint32_t union_root(std::vector<std::uint32_t>& parents, std::uint32_t at) {
  while (parents[at] != at) at = parents[at] = parents[parents[at]];
  return at;
}

}  // namespace

std::vector<EdgeSide> sorted_sides(const Mesh& mesh) {
  std::vector<EdgeSide> sides;
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    const std::vector<std::uint32_t>& face = mesh.faces[i];
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t here = face[k];
      const std::uint32_t next = face[(k + 1) % face.size()];
      sides.push_back(
          {std::min(here, next), std::max(here, next), static_cast<std::uint32_t>(sides.size()), i, here < next});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.number) < std::tie(b.low, b.high, b.number);
  });
  return sides;
}

std::vector<Joint> find_joints(const Mesh& mesh) {
  std::vector<Joint> joints;
  for_each_edge(sorted_sides(mesh), [&](auto begin, auto end) {
    if (end - begin == 2) joints.push_back({begin->face, begin[1].face, begin->forward == begin[1].forward});
  });
  return joints;
}

Neighbours find_neighbours(const Mesh& mesh) {
  Neighbours found;
  found.first_side.push_back(0);
  for (const auto& face : mesh.faces) {
    found.first_side.push_back(found.first_side.back() + static_cast<std::uint32_t>(face.size()));
  }
  found.face.assign(found.first_side.back(), none);
  for_each_edge(sorted_sides(mesh), [&](auto begin, auto end) {
    if (end - begin != 2 || begin->forward == begin[1].forward) return;
    found.face[begin->number] = begin[1].face;
    found.face[begin[1].number] = begin->face;
  });
  return found;
}

std::vector<std::uint32_t> find_shells(const Mesh& mesh) {
  std::vector<std::uint32_t> parents(mesh.faces.size());
  std::iota(parents.begin(), parents.end(), 0U);
  for_each_edge(sorted_sides(mesh), [&](auto begin, auto end) {
    for (auto side = begin; side != end; ++side) {
      const std::uint32_t one = union_root(parents, begin->face);
      const std::uint32_t other = union_root(parents, side->face);
      parents[std::max(one, other)] = std::min(one, other);
    }
  });
  std::vector<std::uint32_t> shells(mesh.faces.size());
  std::uint32_t count = 0;
  for (std::uint32_t face = 0; face < parents.size(); ++face) {
    const std::uint32_t root = union_root(parents, face);
    shells[face] = root == face ? count++ : shells[root];
  }
  return shells;
}

}  // namespace csgsim::solids
