// Counts of ray tracing.
// Used by trace.h and by csgsim trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/counts.h"

namespace csgsim::software {

/// Counts of one kind of rays.
struct RaysMet {
  std::uint64_t rays = 0;
  std::uint64_t cells = 0;                   ///< visited cells
  std::uint64_t tested = 0;                  ///< facets tested against a ray
  std::uint64_t loose = 0;                   ///< tested facets that are outside the directory
  std::uint64_t met = 0;                     ///< facets hit by a ray
  std::uint64_t repeats = 0;                 ///< facets skipped because the ray had already been tested against them
  std::uint64_t hits = 0;                    ///< rays that enter the solid, or are shadowed
  std::vector<std::uint64_t> rays_by_cells;  ///< number of rays by number of visited cells

  void add_cells(std::uint64_t cells_of_ray) {
    if (rays_by_cells.size() <= cells_of_ray) rays_by_cells.resize(cells_of_ray + 1);
    ++rays_by_cells[cells_of_ray];
    cells += cells_of_ray;
  }
};

/// Counts of a traced picture.
struct TraceCounts {
  RaysMet primary;
  RaysMet shadow;
  RaysMet mirror;
  std::uint64_t items = 0;  ///< events of the projective pass that fills an item buffer
  Counts classification;
  std::uint64_t words = 0;  ///< in 32-bit words, without the directory
  Operations projection;    ///< projection of facets, and the pass that fills an item buffer
  Operations traversal;
  Operations intersection;
  Operations shading;
};

/// Operation counters of the parts of a ray tracer.
template <class Count>
struct TraceMeters {
  Count projection;
  Count traversal;
  Count intersection;
  Count classification;
  Count shading;
};

}  // namespace csgsim::software
