#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/counts.h"

namespace csgsim::software {

/// What rays of one kind met.
struct RaysMet {
  std::uint64_t rays = 0;
  std::uint64_t cells = 0;    ///< that were looked into
  std::uint64_t tested = 0;   ///< facets held against a ray
  std::uint64_t loose = 0;    ///< of these, outside the directory
  std::uint64_t met = 0;      ///< facets that a ray meets
  std::uint64_t repeats = 0;  ///< facets of cells that were left out, since the ray had been held against them
  std::uint64_t hits = 0;     ///< rays that get into the solid, or into shadow
  std::vector<std::uint64_t> rays_by_cells;  ///< rays that looked into so many cells

  void add_cells(std::uint64_t cells_of_ray) {
    if (rays_by_cells.size() <= cells_of_ray) rays_by_cells.resize(cells_of_ray + 1);
    ++rays_by_cells[cells_of_ray];
    cells += cells_of_ray;
  }
};

/// What ray tracing a picture did.
struct TraceCounts {
  RaysMet primary;
  RaysMet shadow;
  RaysMet mirror;
  std::uint64_t items = 0;  ///< events of the projective pass that makes an item buffer
  Counts classification;
  std::uint64_t words = 0;  ///< of 32 bits, without the directory
  Operations projection;    ///< of facets into the picture, and of the pass that makes an item buffer
  Operations traversal;
  Operations intersection;
  Operations shading;
};

/// Where the parts of a ray tracer count.
template <class Count>
struct TraceMeters {
  Count projection;
  Count traversal;
  Count intersection;
  Count classification;
  Count shading;
};

}  // namespace csgsim::software
