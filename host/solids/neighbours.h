#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "host/solids/mesh.h"

namespace csgsim::solids {

inline constexpr std::uint32_t none = 0xffffffffU;

/// Which faces join which. The sides of faces are numbered on: side k of a face is from its corner k to the next one.
struct Neighbours {
  std::vector<std::uint32_t> first_side;  ///< of each face, and one past the last
  std::vector<std::uint32_t> face;        ///< of each side the face beyond it; `none` if it is not just one other
};

/// A side of a face.
struct EdgeSide {
  std::uint32_t low;     ///< of its corners the lower one
  std::uint32_t high;    ///< the higher one
  std::uint32_t number;  ///< among the sides of all faces
  std::uint32_t face;
  bool forward;  ///< from the lower corner to the higher one
};

/// Sides along the same edge stand together, in the order of their numbers.
std::vector<EdgeSide> sorted_sides(const Mesh& mesh);

/// Calls visit(begin, end) for the sides along each edge.
template <class Visit>
void for_edges(const std::vector<EdgeSide>& sides, const Visit& visit) {
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(
        begin, sides.end(), [&](const EdgeSide& side) { return side.low != begin->low || side.high != begin->high; });
    visit(begin, end);
    begin = end;
  }
}

/// An edge that just two sides of faces run along.
struct Joint {
  std::uint32_t one;    ///< face
  std::uint32_t other;  ///< face; the same one, if it runs along the edge twice
  bool same_way;        ///< both run along the edge in the same direction
};

/// In order of the edges' corners.
std::vector<Joint> find_joints(const Mesh& mesh);

/// Two faces join at an edge that both run along, in opposite directions, and no third does.
Neighbours find_neighbours(const Mesh& mesh);

/// The number of each face's shell. Faces that have an edge in common are of one shell; shells are numbered in the
/// order of their first faces.
std::vector<std::uint32_t> find_shells(const Mesh& mesh);

}  // namespace csgsim::solids
