#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/facets/screen_facets.h"
#include "sim/software/rays/caster.h"
#include "tests/unit/software/recount_steps.h"
#include "tests/unit/software/scenes.h"

namespace csgsim::testing {

/// Events of each pixel's ray, computed from half-spaces.
class PixelEvents {
 public:
  explicit PixelEvents(const Scene& scene);

  [[nodiscard]] std::span<const software::Event> at(std::int32_t column, std::int32_t row) const {
    return at(static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(column));
  }
  [[nodiscard]] std::span<const software::Event> at(std::size_t pixel) const { return events_[pixel]; }
  [[nodiscard]] std::size_t size() const { return events_.size(); }
  [[nodiscard]] std::uint64_t all() const;

 private:
  std::size_t width_;
  std::vector<std::vector<software::Event>> events_;
};

/// An event of a facet.
struct FacetEvent {
  std::int32_t column = 0;
  std::int32_t row = 0;
  software::Event event;
};

/// A facet on the screen; each pixel of its rectangle is tested against its edges.
struct FacetScan {
  std::uint64_t edges = 0;
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;  ///< within the edges, of all rows
  std::vector<FacetEvent> events;
};

/// Whether a pixel of a facet's rectangle is within its edges.
bool is_within(const software::ScreenFacets& facets, const software::ScreenFacet& facet, std::int32_t column,
               std::int32_t row);

FacetScan scanned(const software::ScreenFacets& facets, const software::ScreenFacet& facet, const PixelEvents& rays);

/// Representation of the picture's numbers.
struct Numbers {
  std::uint64_t longs;  ///< longs of a value: depth, fraction, sign and carry
  std::uint64_t fraction_bits;
};

Numbers numbers_of(const Scene& scene);

/// Operations of scan-converting a polygon: setting up its edges, stepping each edge to each row, a branch per pixel.
Operations edge_setups(std::uint64_t edges, const Numbers& numbers);
Operations row_steps(std::uint64_t rows, std::uint64_t edges, const Numbers& numbers);
Operations pixel_steps(std::uint64_t pixels);
/// Depths along rows: a sum, shifted by the fraction, and compared with both ends of the range.
Operations depths(std::uint64_t pixels, const Numbers& numbers);
/// Edges, rows and pixels of a facet.
Operations conversion(const FacetScan& scan, const Numbers& numbers);

}  // namespace csgsim::testing
