// Groups of adjacent faces that share a plane, apart from rounding. Used by convex_shell.h and pieces.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/solid.h"
#include "host/solids/neighbours.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// Groups of adjacent faces that are in one plane, apart from rounding.
struct Regions {
  std::vector<std::uint32_t> of_face;  ///< region of each face; `none` for an isolated face without area
  std::vector<facet::Plane> planes;    ///< outward planes
  double deviation = 0;                ///< maximum distance of a corner from its face's plane, in model units
};

/// Grows regions, starting with the largest face. Each region absorbs adjacent faces as long as no corner is farther
/// than the tolerance, in model units, from the region's plane. The plane's normal is the sum of the faces' area
/// vectors, and it passes through the mean of the faces' centres, weighted by area. Faces must be flat. Throws
/// WorkError if the work limit is exceeded.
Regions find_regions(const Mesh& mesh, const Neighbours& neighbours, double tolerance, const Work& work);

}  // namespace csgsim::solids
