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

/// Rows of a band; a tile, over which half-spaces that never bound a primitive are left out, has as many columns.
inline constexpr std::uint32_t band_rows = 16;

/// What is counted of rays as such.
struct RayCounts {
  std::uint64_t halfspace_tests = 0;  ///< of a half-space at a pixel
  std::uint64_t intervals = 0;
  std::uint64_t events = 0;
  Operations intersecting;  ///< of intervals
  Operations sorting;       ///< of events
};

/// Rays through the pixels of a view, from the integers that machines draw by (docs/numbers.md).
class RayCaster {
 public:
  /// Keeps references to the geometry and the view. Throws InputError for a face that does not fit the numbers of
  /// machines.
  RayCaster(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view);

  [[nodiscard]] std::uint32_t width() const { return view_.sampling.width; }
  [[nodiscard]] std::uint32_t height() const { return view_.sampling.height; }
  /// 2^n - 1, where nothing is seen.
  [[nodiscard]] std::uint32_t farthest() const { return (std::uint32_t{1} << view_.sampling.z_bits) - 1; }

  /// Up to band_rows rows from that one, which is a multiple of it. With `counts`, what is done is added to them.
  void cast(std::uint32_t first_row, RayBand& band, RayCounts* counts = nullptr) const;

 private:
  const facet::Geometry& geometry_;
  const view::View& view_;
  std::vector<TilePlanes> planes_;                    ///< one a primitive
  std::vector<std::vector<std::uint32_t>> touching_;  ///< for each band of rows the primitives with pixels there
};

}  // namespace csgsim::software
