#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/solid.h"
#include "host/solids/neighbours.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// Faces that rounding apart are in one plane, and hang together.
struct Regions {
  std::vector<std::uint32_t> of_face;  ///< `none` for a face without area that no region is beside
  std::vector<facet::Plane> planes;    ///< outward
  double deviation = 0;                ///< the farthest that a corner is off its face's plane
};

/// From the largest face down, each gathers the faces beside it, and those beside them, for as long as no corner is
/// farther than the tolerance, in model units, off the plane of all that it has gathered: the one with the sum of their
/// area vectors, through the mean of their middles, weighted by area. Faces have to be flat.
/// Throws WorkError past the limit on work.
Regions find_regions(const Mesh& mesh, const Neighbours& neighbours, double tolerance, const Work& work);

}  // namespace csgsim::solids
