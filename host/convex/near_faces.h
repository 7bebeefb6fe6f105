#pragma once

#include <array>
#include <cstdint>

#include "host/facet/geometry.h"
#include "host/model/tree.h"

namespace csgsim::convex {

/// Components of normals closer than this are surely meant to be equal: six digits of a rotation are off by 5e-7 in
/// each entry, so that a chain of ten matrices turns a normal by no more.
inline constexpr double near_normals = 1e-5;

/// Offsets relative to the model's diagonal. Of tilted planes as for normals. Planes that are parallel may be apart on
/// purpose (an overlap of 0.001 on 300); closer than two steps of 20 bits of depth an overlap would do nothing.
inline constexpr double near_offsets = 1e-5;
inline constexpr double near_parallel_offsets = 2e-6;

/// Nodes of the file that have a face each, which overlap, in planes that are near but not the same.
struct NearFaces {
  std::uint64_t pairs = 0;               ///< of nodes
  bool are_more = false;                 ///< not all were looked at
  std::array<std::uint32_t, 2> first{};  ///< primitives of the first pair in the order of the file, if there is one
};

/// Pairs of faces that are looked at before it is enough.
inline constexpr std::uint64_t most_near_faces = 1'000'000;

/// Takes n log n of the planes, and the pairs of faces in near planes, of each at most most_near_faces.
NearFaces near_faces(const model::Tree& tree, const facet::Geometry& geometry);

}  // namespace csgsim::convex
