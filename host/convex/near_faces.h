// Detection of overlapping faces in nearly equal planes.
// Used by sim/session and sim/app.
#pragma once

#include <array>
#include <cstdint>

#include "host/facet/geometry.h"
#include "host/model/tree.h"

namespace csgsim::convex {

/// Normals whose components differ by less than this are assumed to be meant as equal: six printed digits of a rotation
/// cause errors of 5e-7 per entry, so a chain of ten matrices turns a normal by less.
inline constexpr double near_normals = 1e-5;

/// Limits of differences in offset, relative to the model's diagonal. For tilted planes the limit equals that of
/// normals. Parallel planes may be apart on purpose (an overlap of 0.001 in 300), but an overlap below two steps of
/// 20-bit depth would have no effect.
inline constexpr double near_offsets = 1e-5;
inline constexpr double near_parallel_offsets = 2e-6;

/// Pairs of nodes of the file with overlapping faces in nearly equal planes.
struct NearFaces {
  std::uint64_t pairs = 0;               ///< number of pairs of nodes
  bool is_incomplete = false;            ///< whether the limit was reached before all pairs were tested
  std::array<std::uint32_t, 2> first{};  ///< primitives of the first pair in file order; valid if there are pairs
};

/// Maximum number of pairs of faces that are tested.
inline constexpr std::uint64_t max_near_faces = 1'000'000;

/// Finds the pairs of nodes with overlapping faces in nearly equal planes. Takes n log n time in the number of planes,
/// plus the time for at most max_near_faces pairs of faces.
NearFaces near_faces(const model::Tree& tree, const facet::Geometry& geometry);

/// Prints a one-line warning if there are such pairs. `is_snapped`: rotations have been restored from printed digits.
void warn_of_near_faces(const model::Tree& tree, const facet::Geometry& geometry, bool is_snapped);

}  // namespace csgsim::convex
