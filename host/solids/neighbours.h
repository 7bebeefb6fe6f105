// Adjacency of faces, and connected shells.
// Used throughout host/solids.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/solids/mesh.h"

namespace csgsim::solids {

inline constexpr std::uint32_t none = 0xffffffffU;

/// Adjacency of faces. Sides are numbered consecutively over all faces; side k of a face runs from its corner k to the
/// next one.
struct Neighbours {
  std::vector<std::uint32_t> first_side;  ///< first side of each face, and the total number of sides as last entry
  std::vector<std::uint32_t> face;        ///< neighbour at each side; `none` unless there is exactly one
};

/// A side of a face.
struct EdgeSide {
  std::uint32_t low;     ///< lower index of its two corners
  std::uint32_t high;    ///< higher index
  std::uint32_t number;  ///< index among the sides of all faces
  std::uint32_t face;
  bool forward;  ///< whether the side runs from the lower corner to the higher one
};

/// All sides, sorted by edge, then by number.
std::vector<EdgeSide> sorted_sides(const Mesh& mesh);

/// Calls visit(begin, end) for the sides along each edge.
template <class Visit>
void for_each_edge(const std::vector<EdgeSide>& sides, const Visit& visit) {
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(
        begin, sides.end(), [&](const EdgeSide& side) { return side.low != begin->low || side.high != begin->high; });
    visit(begin, end);
    begin = end;
  }
}

/// An edge with exactly two sides along it.
struct Joint {
  std::uint32_t one;    ///< face index
  std::uint32_t other;  ///< face index; equal to `one` if that face runs along the edge twice
  bool same_way;        ///< whether both sides run in the same direction
};

/// The edges with exactly two sides, sorted by their corners.
std::vector<Joint> find_joints(const Mesh& mesh);

/// Finds the neighbours of all faces. Two faces are neighbours at an edge if they run along it in opposite directions
/// and no third face does.
Neighbours find_neighbours(const Mesh& mesh);

/// The shell number of each face. Faces with a common edge belong to one shell; shells are numbered in the order of
/// their first faces.
std::vector<std::uint32_t> find_shells(const Mesh& mesh);

}  // namespace csgsim::solids
