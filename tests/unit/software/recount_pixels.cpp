#include "tests/unit/software/recount_pixels.h"

#include <algorithm>

namespace csgsim::testing {

using enum processors::Operation;

using software::Event;
using software::ScreenFacet;
using software::ScreenFacets;

PixelEvents::PixelEvents(const Scene& scene) : width_(scene.view.sampling.width) {
  const software::RayCaster caster(scene.tree, scene.geometry, scene.view);
  software::RayBand band;
  for (std::uint32_t row = 0; row < caster.height(); row += software::band_rows) {
    caster.cast(row, band);
    for (std::size_t ray = 0; ray < band.rays(); ++ray) {
      const std::span<const Event> events = band.events_of(ray);
      events_.emplace_back(events.begin(), events.end());
    }
  }
}

std::uint64_t PixelEvents::all() const {
  std::uint64_t sum = 0;
  for (const std::vector<Event>& events : events_) sum += events.size();
  return sum;
}

bool is_within(const ScreenFacets& facets, const ScreenFacet& facet, std::int32_t column, std::int32_t row) {
  return std::ranges::all_of(facets.bounds_of(facet), [&](const view::FixedLinear& bound) {
    return bound.a * column + bound.b * row + bound.c >= 0;
  });
}

FacetScan scanned(const ScreenFacets& facets, const ScreenFacet& facet, const PixelEvents& rays) {
  FacetScan scan;
  scan.edges = facets.bounds_of(facet).size();
  for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row) {
    ++scan.rows;
    for (std::int32_t column = facet.pixels.x0; column <= facet.pixels.x1; ++column) {
      if (!is_within(facets, facet, column, row)) continue;
      ++scan.columns;
      for (const Event& event : rays.at(column, row)) {
        if (event.crossing == facet.crossing()) scan.events.push_back({column, row, event});
      }
    }
  }
  return scan;
}

Numbers numbers_of(const Scene& scene) {
  const view::Sampling& sampling = scene.view.sampling;
  return {(sampling.z_bits + sampling.fraction_bits + 2 + 31) / 32, sampling.fraction_bits};
}

/// Three coefficients and two products; two quotients of two digits with a product each; four longs are stored.
Operations edge_setups(std::uint64_t edges, const Numbers& numbers) {
  const std::uint64_t longs = numbers.longs;
  return edges * steps({{load_long, 3 * longs},
                        {multiply, 2 * longs + 4},
                        {divide, 4},
                        {add_long, 2 * longs + 4},
                        {store_long, 4}});
}

/// An edge's column and remainder are stepped and compared with the ends found before; then the first depth is stepped.
Operations row_steps(std::uint64_t rows, std::uint64_t edges, const Numbers& numbers) {
  Operations row = edges * steps({{load_long, 4}, {add_long, 2}, compare_long, {store_long, 2}, compare, {branch, 2}});
  row += numbers.longs * steps({{load_long, 2}, add_long, store_long});
  row += steps({compare, branch, branch_taken});
  return rows * row;
}

Operations pixel_steps(std::uint64_t pixels) { return steps({{branch_taken, pixels}}); }

Operations depths(std::uint64_t pixels, const Numbers& numbers) {
  Operations depth = numbers.longs * steps({add_long, shift_long, {shifted_bit, numbers.fraction_bits}});
  depth += steps({{compare_long, 2}, {branch, 2}});
  return pixels * depth;
}

Operations conversion(const FacetScan& scan, const Numbers& numbers) {
  Operations sum = edge_setups(scan.edges, numbers);
  sum += row_steps(scan.rows, scan.edges, numbers);
  sum += pixel_steps(scan.columns);
  return sum;
}

}  // namespace csgsim::testing
