// The cut of a polytope's faces by a plane.
// Used by carver.h and clip.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/solid.h"

namespace csgsim::convex {

/// The position of a vertex relative to a half-space.
enum class VertexSide : std::uint8_t { in, on, out };

using FaceCorners = std::vector<std::uint32_t>;

/// The tolerance to try after one that is `factor` times the usual tolerance, as such a factor. The sequence starts at
/// 1, continues with fractions down to the level of rounding errors, and then with multiples.
double next_tolerance_factor(double factor);

/// The remaining part of a face that is not entirely inside; it has no corners if nothing remains.
struct CutFace {
  std::uint32_t face = 0;
  FaceCorners corners;
};

/// The result of cutting a polytope by a plane.
struct Cut {
  std::vector<CutFace> faces;     ///< the faces that change
  std::vector<glm::dvec3> added;  ///< new vertices, numbered consecutively after those of the polytope
  FaceCorners cap;                ///< corners of the polygon that closes the cut
};

/// Cuts the given faces, in ascending order, by a plane. `faces` must include every face with a vertex that is not
/// inside; `sides` are the sides of all vertices. Empty if the cut is not a single polygon.
std::optional<Cut> cut_faces(const Polytope& polytope, std::span<const std::uint32_t> faces, const facet::Plane& plane,
                             const std::vector<VertexSide>& sides);

/// Removes vertices that no face uses.
void drop_unused_vertices(Polytope& polytope);

}  // namespace csgsim::convex
