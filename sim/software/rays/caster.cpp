#include "sim/software/rays/caster.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "sim/software/rays/longs.h"
#include "sim/software/rays/quadric_depths.h"
#include "sim/software/rays/sort_events.h"
#include "sim/software/rays/span.h"

namespace csgsim::software {

namespace {

using view::FixedLinear;
using view::PixelRect;

/// Width of a tile in pixels. A tile omits the half-spaces that bound no primitive in it.
constexpr std::int32_t tile_columns = 64;

/// Unshifted depths of a row of a tile: the maximum of the front planes and the minimum of the back planes.
struct RowDepths {
  std::array<std::int64_t, tile_columns> fronts;
  std::array<std::int64_t, tile_columns> backs;
};

template <class Better, class Count>
void sweep(std::span<const FixedLinear> planes, const Span& span, std::int64_t y, std::int64_t* extremes,
           const Better& better, std::uint64_t longs, Count& count) {
  const std::int32_t columns = span.columns();
  for (const FixedLinear& plane : planes) {
    std::int64_t value = plane.a * span.first + plane.b * y + plane.c;
    for (std::int32_t i = 0; i < columns; ++i) {
      const std::int64_t extreme = better(extremes[i], value);
      if constexpr (Count::counts) {
        if (extreme != extremes[i]) count(Operation::store_long, longs);
      }
      extremes[i] = extreme;
      value += plane.a;
    }
  }
}

/// Counts the operations that a processor needs for the planes of a primitive in a row. A plane's value occupies
/// `longs` longs.
template <class Count>
void count_row(Count& count, std::size_t planes, std::size_t edges, const Span& span, std::uint64_t longs) {
  if constexpr (!Count::counts) return;
  const auto columns = static_cast<std::uint64_t>(std::max(0, span.columns()));
  // An edge test: step to the next row, divide digit by digit (in words), and update the limit if necessary.
  constexpr std::uint64_t digits = 2;
  count(Operation::load_long, 3 * longs * edges);
  count(Operation::add_long, longs * edges);
  count(Operation::divide, digits * edges);
  count(Operation::multiply, digits * edges);
  count(Operation::add_long, digits * edges);
  count(Operation::compare, edges);
  count(Operation::branch, edges);
  // A plane: step to the next row, then at each pixel compute the next value and compare it with the extreme in memory,
  // replacing it if necessary.
  count(Operation::load_long, 2 * longs * planes);
  count(Operation::add_long, longs * planes);
  count(Operation::store_long, longs * planes);
  const std::uint64_t tests = planes * columns;
  count(Operation::load_long, longs * tests);
  count(Operation::compare_long, longs * tests);
  count(Operation::add_long, longs * tests);
  count(Operation::branch, tests);
  count(Operation::branch_taken, tests);
}

/// An intersection in a row, in the order of primitives.
struct Found {
  std::uint32_t column = 0;
  Interval interval;
};

/// Intersects the rays of one band with one primitive after another.
template <class Count>
class BandCaster {
 public:
  BandCaster(const facet::Geometry& geometry, const view::View& view, const RayBand& band)
      : geometry_(geometry), view_(view), band_(band), rows_(band.rows), longs_(longs_of(view.sampling)) {}

  void add(std::uint32_t primitive, const TilePlanes& planes) {
    if (planes.nowhere) return;
    const PixelRect& pixels = view_.extents[primitive].pixels;
    const auto first_row = static_cast<std::int32_t>(band_.first_row);
    const std::int32_t y0 = std::max(pixels.y0, first_row);
    const std::int32_t y1 = std::min(pixels.y1, first_row + static_cast<std::int32_t>(band_.rows) - 1);
    for (std::int32_t x0 = pixels.x0; x0 <= pixels.x1; x0 += tile_columns) {
      const PixelRect tile{x0, y0, std::min(pixels.x1, x0 + tile_columns - 1), y1};
      count_tile(select_bounding(planes, tile, left_));
      for (std::int32_t y = y0; y <= y1; ++y) add_row(primitive, planes.edges, {tile.x0, tile.x1}, y);
    }
  }

  /// Collects the intervals of the band ray by ray.
  void gather(RayBand& band) const {
    const std::size_t rays = band.rays();
    band.interval_begins.assign(rays + 1, 0);
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (const Found& found : rows_[row]) ++band.interval_begins[row * band.width + found.column + 1];
    }
    for (std::size_t ray = 0; ray < rays; ++ray) band.interval_begins[ray + 1] += band.interval_begins[ray];
    band.intervals.resize(band.interval_begins[rays]);
    std::vector<std::size_t> place(band.interval_begins.begin(), band.interval_begins.end() - 1);
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (const Found& found : rows_[row]) band.intervals[place[row * band.width + found.column]++] = found.interval;
    }
  }

  void add_counts(RayCounts& counts) const {
    counts.halfspace_tests += halfspace_tests_;
    counts.intersecting += count_.done();
  }

 private:
  /// Counts moving an interval to its ray's range: counting per ray, prefix sums, and a copy.
  void count_gathered() {
    count_(Operation::load, 3);
    count_(Operation::load_long, 4);
    count_(Operation::add_long, 4);
    count_(Operation::store, 1);
    count_(Operation::store_long, 4);
    count_(Operation::branch_taken, 2);
  }

  /// Counts evaluating a plane at four corners (three by additions) and comparing each value with the current maximum
  /// and the leaders.
  void count_tile(std::uint64_t tested) {
    constexpr std::uint64_t corners = 4;
    const std::uint64_t values = longs_ * tested;
    count_(Operation::multiply, 2 * values);
    count_(Operation::load_long, (3 + 2 * corners) * values);
    count_(Operation::add_long, (2 + corners) * values);
    count_(Operation::compare_long, 2 * corners * values);
    count_(Operation::branch, 2 * corners * tested);
    count_(Operation::store_long, corners * values);
  }

  void add_row(std::uint32_t primitive, std::span<const TilePlanes::Edge> edges, Span span, std::int32_t y) {
    for (const TilePlanes::Edge& edge : edges) {
      if (span.empty()) break;
      clip(span, edge.linear.a, edge.linear.b * y + edge.linear.c, edge.positive);
    }
    count_row(count_, left_.fronts.size() + left_.backs.size(), edges.size(), span, longs_);
    if (span.empty()) return;
    const auto columns = static_cast<std::size_t>(span.columns());
    halfspace_tests_ += columns * (left_.fronts.size() + left_.backs.size());
    std::fill_n(depths_.fronts.begin(), columns, std::numeric_limits<std::int64_t>::min());
    std::fill_n(depths_.backs.begin(), columns, std::numeric_limits<std::int64_t>::max());
    sweep(
        left_.fronts, span, y, depths_.fronts.data(), [](std::int64_t a, std::int64_t b) { return a > b ? a : b; },
        longs_, count_);
    sweep(
        left_.backs, span, y, depths_.backs.data(), [](std::int64_t a, std::int64_t b) { return a < b ? a : b; },
        longs_, count_);
    for (std::size_t i = 0; i < columns; ++i) add_pixel(primitive, span.first + static_cast<std::int32_t>(i), y, i);
  }

  void add_pixel(std::uint32_t primitive, std::int32_t x, std::int32_t y, std::size_t i) {
    const unsigned shift = view_.sampling.fraction_bits;
    const std::int64_t farthest = (std::int64_t{1} << view_.sampling.z_bits) - 1;
    Depths depths{std::max<std::int64_t>(0, depths_.fronts[i] >> shift), std::min(farthest, depths_.backs[i] >> shift)};
    for (const facet::QuadricSide side : geometry_.solids[primitive].quadrics) {
      count_quadric(view_.quadrics[side.quadric], count_);
      depths = intersect_quadric(depths, view_, side, x, y);
    }
    for (std::uint64_t value = 0; value < 2 * longs_; ++value) count_.shift(shift);
    count_(Operation::load_long, 2 * longs_);
    count_(Operation::compare_long, 3);
    count_(Operation::branch, 3);
    if (depths.front >= depths.back) return;
    count_(Operation::store_long, 2);
    count_(Operation::store);
    count_gathered();
    rows_[static_cast<std::uint32_t>(y) - band_.first_row].push_back(
        {static_cast<std::uint32_t>(x),
         {primitive, static_cast<std::uint32_t>(depths.front), static_cast<std::uint32_t>(depths.back)}});
  }

  const facet::Geometry& geometry_;
  const view::View& view_;
  const RayBand& band_;
  std::vector<std::vector<Found>> rows_;
  std::uint64_t longs_;  ///< longs per plane value
  TilePlanes left_;
  RowDepths depths_{};
  Count count_;
  std::uint64_t halfspace_tests_ = 0;
};

template <class Count>
void cast_with(const facet::Geometry& geometry, const view::View& view, std::span<const std::uint32_t> touching,
               std::span<const TilePlanes> planes, RayBand& band, RayCounts* counts) {
  BandCaster<Count> caster(geometry, view, band);
  for (const std::uint32_t primitive : touching) caster.add(primitive, planes[primitive]);
  caster.gather(band);
  Count sorting;
  sort_events(band, (std::uint32_t{1} << view.sampling.z_bits) - 1, sorting);
  if (counts == nullptr) return;
  caster.add_counts(*counts);
  counts->intervals += band.intervals.size();
  counts->events += band.events.size();
  counts->sorting += sorting.done();
}

}  // namespace

RayCaster::RayCaster(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view)
    : geometry_(geometry), view_(view), touching_((view.sampling.height + band_rows - 1) / band_rows) {
  planes_.reserve(geometry.solids.size());
  for (std::uint32_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    planes_.push_back(planes_of(tree, geometry, view, primitive));
    const PixelRect& pixels = view.extents[primitive].pixels;
    if (pixels.empty()) continue;
    const auto last = static_cast<std::uint32_t>(pixels.y1) / band_rows;
    for (std::uint32_t band = static_cast<std::uint32_t>(pixels.y0) / band_rows; band <= last; ++band)
      touching_[band].push_back(primitive);
  }
}

void RayCaster::cast(std::uint32_t first_row, RayBand& band, RayCounts* counts) const {
  band.width = width();
  band.first_row = first_row;
  band.rows = std::min(band_rows, height() - first_row);
  const std::span<const std::uint32_t> touching = touching_[first_row / band_rows];
  const auto cast = counts == nullptr ? cast_with<Uncounted> : cast_with<Counting>;
  cast(geometry_, view_, touching, planes_, band, counts);
}

}  // namespace csgsim::software
