#pragma once

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

/// Of each face the number of its shell. Faces that have an edge in common are of one shell; shells are numbered in the
/// order of their first faces.
std::vector<std::uint32_t> find_shells(const Mesh& mesh);

}  // namespace csgsim::solids
