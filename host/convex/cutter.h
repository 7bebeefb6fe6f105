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

/// Of a vertex and a half-space.
enum class VertexSide : std::uint8_t { in, on, out };

using FaceCorners = std::vector<std::uint32_t>;

/// The tolerances that cuts are tried with: 1, parts of it down to where rounding begins, multiples of it.
double next_tolerance(double times);

/// What is left of a face that is not wholly in; without corners if that is nothing.
struct CutFace {
  std::uint32_t face = 0;
  FaceCorners corners;
};

/// How a plane cuts a polytope: what faces become, and the polygon that closes it.
struct Cut {
  std::vector<CutFace> faces;
  std::vector<glm::dvec3> added;  ///< vertices, numbered after those of the polytope
  FaceCorners cap;
};

/// Cuts the faces of a polytope of these numbers, ascending, among which are all with a vertex that is not in. `sides`
/// are those of the vertices. Nothing if the cut is not one polygon.
std::optional<Cut> cut_faces(const Polytope& polytope, std::span<const std::uint32_t> faces, const facet::Plane& plane,
                             const std::vector<VertexSide>& sides);

/// Takes out vertices that no face has.
void drop_unused_vertices(Polytope& polytope);

}  // namespace csgsim::convex
