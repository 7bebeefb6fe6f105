// Intersection of the rays of a picture with primitives.
// Used by sim/studies.
#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/cost/operations.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/rays/tile_planes.h"

namespace csgsim::software {

/// Number of rows in a band.
inline constexpr std::uint32_t band_rows = 16;

/// Counts of ray casting.
struct RayCounts {
  std::uint64_t halfspace_tests = 0;  ///< evaluations of a half-space at a pixel
  std::uint64_t intervals = 0;
  std::uint64_t events = 0;
  Operations intersecting;  ///< to compute intervals
  Operations sorting;       ///< to sort events
};

/// Casts rays through the pixels of a view, using the integers of the machines (docs/numbers.md).
class RayCaster {
 public:
  /// Keeps references to the geometry and the view. Throws InputError if a face exceeds the number range of the
  /// machines.
  RayCaster(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view);

  [[nodiscard]] std::uint32_t width() const { return view_.sampling.width; }
  [[nodiscard]] std::uint32_t height() const { return view_.sampling.height; }
  /// 2^n - 1, the depth where nothing is visible.
  [[nodiscard]] std::uint32_t farthest() const { return (std::uint32_t{1} << view_.sampling.z_bits) - 1; }

  /// Casts up to band_rows rows starting at `first_row`, a multiple of band_rows. If `counts` is given, the work is
  /// added to it.
  void cast(std::uint32_t first_row, RayBand& band, RayCounts* counts = nullptr) const;

 private:
  const facet::Geometry& geometry_;
  const view::View& view_;
  std::vector<TilePlanes> planes_;                    ///< one per primitive
  std::vector<std::vector<std::uint32_t>> touching_;  ///< per band of rows, the primitives with pixels in it
};

}  // namespace csgsim::software
