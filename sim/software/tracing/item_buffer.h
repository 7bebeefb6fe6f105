// Item buffer of a picture.
// Used by trace.cpp in place of primary rays.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/software/rays/span.h"
#include "sim/software/tracing/primary_rays.h"

namespace csgsim::software {

/// The visible facet at each pixel (Weghorst and others 1984; thesis 5.3.1), found by scan conversion of all facets:
/// the sorted events of each pixel of a row are classified by the list structure, and the pointer into it is stored
/// too.
template <class Count>
class ItemBuffer {
 public:
  ItemBuffer(const TraceScene& scene, Sequences<Count>& sequences, TraceMeters<Count>& meters, std::uint64_t& items)
      : scene_(scene),
        longs_(longs_of(scene.view().sampling)),
        count_(meters.projection),
        items_(items),
        points_(scene, sequences, meters.classification),
        rows_(scene.height()),
        met_(scene.width()) {
    const std::vector<ScreenFacet>& facets = scene.screen().facets;
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
      for (std::int32_t row = facets[i].pixels.y0; row <= facets[i].pixels.y1; ++row)
        rows_[static_cast<std::size_t>(row)].push_back(i);
    }
  }

  /// Computes the visible facets of a row.
  void fill(std::uint32_t row, std::vector<Hit>& hits) {
    for (std::vector<Met>& one : met_) one.clear();
    for (const std::uint32_t facet : rows_[row]) convert(facet, static_cast<std::int32_t>(row));
    hits.resize(scene_.width());
    for (std::size_t column = 0; column < hits.size(); ++column) {
      sort(met_[column]);
      hits[column] = classified(met_[column]);
      count_(Operation::store_long, 2);
    }
  }

  /// Per pixel, a pointer to a facet and one into the list structure.
  [[nodiscard]] std::uint64_t words() const { return 2 * std::uint64_t{scene_.width()} * scene_.height(); }

 private:
  void convert(std::uint32_t number, std::int32_t row) {
    const ScreenFacets& facets = scene_.screen();
    const ScreenFacet& facet = facets.facets[number];
    count_span(facet, facets.for_row(facet, row, [&](std::int32_t column, const Event& event) {
      met_[static_cast<std::size_t>(column)].push_back({event, number});
    }));
  }

  /// Counts edge tests and plane values along a row in the same way as sim/software/rays.
  void count_span(const ScreenFacet& facet, const Span& span) {
    if constexpr (!Count::counts) return;
    const std::uint64_t bounds = scene_.screen().bounds_of(facet).size();
    const auto columns = static_cast<std::uint64_t>(std::max(0, span.columns()));
    count_(Operation::load_long, 3 * longs_ * bounds + 2 * longs_);
    count_(Operation::divide, 2 * bounds);
    count_(Operation::multiply, 2 * bounds);
    count_(Operation::add_long, (longs_ + 2) * bounds + longs_);
    count_(Operation::compare, bounds);
    count_(Operation::branch, bounds);
    count_(Operation::add_long, longs_ * columns);
    for (std::uint64_t i = 0; i < longs_ * columns; ++i) count_.shift(scene_.screen().fraction_bits);
    count_(Operation::compare_long, 2 * columns);
    count_(Operation::branch, 2 * columns);
    count_(Operation::store_long, 2 * columns);
    count_(Operation::branch_taken, columns);
  }

  void sort(std::vector<Met>& met) {
    items_ += met.size();
    std::sort(met.begin(), met.end(), [&](const Met& a, const Met& b) {
      count_(Operation::load_long, 2);
      count_(Operation::compare_long);
      count_(Operation::branch_taken);
      count_(Operation::store_long);
      return a < b;
    });
  }

  const Hit& classified(const std::vector<Met>& met) {
    points_.begin();
    for (std::size_t begin = 0; begin < met.size();) {
      std::size_t end = begin + 1;
      while (end < met.size() && met[end].event.depth == met[begin].event.depth) ++end;
      if (points_.add_point(std::span(met).subspan(begin, end - begin))) break;
      begin = end;
    }
    return points_.hit();
  }

  const TraceScene& scene_;
  std::uint64_t longs_;
  Count& count_;
  std::uint64_t& items_;
  PointsOfRay<Count> points_;
  std::vector<std::vector<std::uint32_t>> rows_;  ///< per row, its facets
  std::vector<std::vector<Met>> met_;             ///< per column of a row
};

}  // namespace csgsim::software
