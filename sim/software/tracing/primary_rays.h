// Tracing of primary rays through a directory.
// Used by trace.cpp and item_buffer.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/software/coherences/sequences.h"
#include "sim/software/rays/longs.h"
#include "sim/software/space/arithmetic.h"
#include "sim/software/tracing/counts.h"
#include "sim/software/tracing/piercing.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tracing/trace_scene.h"

namespace csgsim::software {

/// An event and the facet that causes it.
struct Met {
  Event event;
  std::uint32_t facet = 0;  ///< index into ScreenFacets::facets

  bool operator<(const Met& other) const { return event < other.event; }
};

/// The point at which a primary ray enters the solid.
struct Hit {
  VisibleSurface seen;
  std::uint32_t facet = TraceScene::none;  ///< index into ScreenFacets::facets
  std::uint32_t before =
      TraceScene::none;  ///< list element of the preceding surfaces, which identifies the medium of a secondary ray
};

/// Classifies the events of a ray point by point with the list structure.
template <class Count>
class PointsOfRay {
 public:
  PointsOfRay(const TraceScene& scene, Sequences<Count>& sequences, Count& count)
      : scene_(scene), sequences_(sequences), count_(count) {}

  void begin() {
    hit_ = {{scene_.screen().farthest, VisibleSurface::nothing_seen}, TraceScene::none, TraceScene::none};
    events_.clear();
    element_ = Sequences<Count>::none;
  }

  /// Adds all events at the next depth, in order; returns whether the ray enters the solid there.
  bool add_point(std::span<const Met> point) {
    const std::uint32_t before = element_;
    const std::size_t begin = events_.size();
    count_.point();
    for (const Met& met : point) {
      count_(Operation::load_long);
      count_(Operation::compare_long);
      count_(Operation::branch);
      events_.push_back(met.event);
      element_ = sequences_.after(element_, met.event.primitive(), count_);
    }
    if (!sequences_.is_in(element_, point.size(), count_)) return false;
    const std::span<const Event> events(events_);
    hit_.seen = {point[0].event.depth, sequences_.owner(events.first(begin), events.subspan(begin), count_)};
    hit_.before = before;
    for (const Met& met : point) {
      if (met.event.primitive() == hit_.seen.owner) hit_.facet = met.facet;
    }
    return true;
  }

  [[nodiscard]] const Hit& hit() const { return hit_; }

 private:
  const TraceScene& scene_;
  Sequences<Count>& sequences_;
  Count& count_;
  Hit hit_;
  std::vector<Event> events_;
  std::uint32_t element_ = 0;
};

/// Counts the test of a projected facet at a pixel: the rectangle, then its bounds until one fails, and the depth.
/// Multiplying a coefficient by a column takes two word multiplications per long.
template <class Count>
void count_projected_test(const ScreenFacets& facets, const ScreenFacet& facet, std::int32_t column, std::int32_t row,
                          std::uint64_t longs, Count& count) {
  if constexpr (!Count::counts) return;
  count(Operation::load, 4);
  count(Operation::compare, 4);
  count(Operation::branch, 4);
  const view::PixelRect& pixels = facet.pixels;
  if (column < pixels.x0 || column > pixels.x1 || row < pixels.y0 || row > pixels.y1) return;
  const auto value = [&] {
    count(Operation::load_long, 3 * longs);
    count(Operation::multiply, 4 * longs);
    count(Operation::add_long, 4 * longs);
    count(Operation::compare);
    count(Operation::branch);
  };
  for (const view::FixedLinear& bound : facets.bounds_of(facet)) {
    value();
    if (value_at(bound, column, row) < 0) return;
  }
  value();
  count.shift(facets.fraction_bits);
}

/// Traces the rays of pixels through a directory. The cells determine which facets are tested; the tests use the
/// integers of the machines, so that the picture equals theirs.
template <class Count>
class PrimaryRays final : public CellVisitor {
 public:
  PrimaryRays(const TraceScene& scene, const Directory& directory, const TraceOptions& options,
              Sequences<Count>& sequences, TraceMeters<Count>& meters, RaysMet& met)
      : scene_(scene),
        directory_(directory),
        test_(options.facet_test),
        has_mailboxes_(options.has_mailboxes),
        longs_(longs_of(scene.view().sampling)),
        meters_(meters),
        met_(met),
        points_(scene, sequences, meters.classification),
        last_ray_(scene.facets().facets.size()) {}

  const Hit& trace(std::int32_t column, std::int32_t row) {
    column_ = column;
    row_ = row;
    ++met_.rays;
    ++ray_;
    cells_ = 0;
    pending_.clear();
    settled_depth_ = -1;
    is_done_ = false;
    points_.begin();
    count_products(meters_.traversal, 6);
    const SpaceRay ray = scene_.ray_of(column, row);
    if (test_ == FacetTest::space) {
      piercing_.emplace(ray);
      count_quotients(meters_.traversal, 2);
    }
    test_loose_facets();
    directory_.walk(ray, *this, meters_.traversal);
    if (!is_done_) settle(pending_.size());
    met_.hits += points_.hit().seen.owner != VisibleSurface::nothing_seen ? 1U : 0U;
    met_.add_cells(cells_);
    return points_.hit();
  }

  bool visit(const Cell& cell) override {
    ++cells_;
    for (const std::uint32_t facet : cell.facets) {
      if (has_mailboxes_ && was_tested(facet)) continue;
      const std::uint32_t screen = scene_.screen_of(facet);
      ++met_.tested;
      meters_.intersection(Operation::load_long, 2);
      meters_.intersection(Operation::branch, 2);
      if (screen != TraceScene::none) test_facet(screen);
    }
    const double known = scene_.depth_at(cell.settled);
    std::size_t due = 0;
    while (due < pending_.size() && pending_[due].event.depth + 1.0 <= known) ++due;
    meters_.intersection(Operation::compare_long, due + 1);
    meters_.intersection(Operation::branch, due + 1);
    settle(due);
    return !is_done_;
  }

 private:
  void test_loose_facets() {
    const std::span<const std::uint32_t> loose = scene_.loose_in(static_cast<std::uint32_t>(row_));
    meters_.intersection(Operation::load_long, loose.size());
    for (const std::uint32_t screen : loose) {
      const view::PixelRect& pixels = scene_.screen().facets[screen].pixels;
      meters_.intersection(Operation::compare, 2);
      meters_.intersection(Operation::branch, 2);
      if (column_ < pixels.x0 || column_ > pixels.x1) continue;
      ++met_.tested;
      ++met_.loose;
      test_facet(screen);
    }
  }

  bool was_tested(std::uint32_t facet) {
    meters_.intersection(Operation::load_long, 2);
    meters_.intersection(Operation::compare_long);
    meters_.intersection(Operation::branch);
    if (last_ray_[facet] == ray_) {
      ++met_.repeats;
      return true;
    }
    meters_.intersection(Operation::store_long);
    last_ray_[facet] = ray_;
    return false;
  }

  void test_facet(std::uint32_t screen) {
    const ScreenFacets& facets = scene_.screen();
    const ScreenFacet& facet = facets.facets[screen];
    meters_.intersection(Operation::call);
    meters_.intersection(Operation::come_back);
    count_test(facet);
    const std::optional<Event> event = facets.event_at(facet, column_, row_);
    // A facet without a mailbox may be tested again after its event has been processed.
    if (!event || static_cast<std::int64_t>(event->depth) <= settled_depth_) return;
    const Met met{*event, screen};
    const auto place = std::lower_bound(pending_.begin(), pending_.end(), met);
    const auto behind = static_cast<std::uint64_t>(pending_.end() - place);
    meters_.intersection(Operation::load_long, 1 + behind);
    meters_.intersection(Operation::compare_long, 1 + behind);
    meters_.intersection(Operation::store_long, 2 + 2 * behind);
    meters_.intersection(Operation::branch_taken, 1 + behind);
    if (place != pending_.end() && place->event == *event) return;
    ++met_.met;
    pending_.insert(place, met);
  }

  void count_test(const ScreenFacet& facet) {
    if constexpr (!Count::counts) return;
    if (test_ == FacetTest::projected)
      return count_projected_test(scene_.screen(), facet, column_, row_, longs_, meters_.intersection);
    // The near cap, where a ray starts inside a primitive, is not a polygon.
    if (facet.facet == ScreenFacet::near_cap) return;
    const std::span<const glm::dvec3> corners = scene_.facets().corners_of(facet.facet);
    if (corners.size() < 3 || piercing_->through(corners, meters_.intersection) == 0) return;
    count_distance(meters_.intersection);
  }

  /// Processes the first `due` pending events.
  void settle(std::size_t due) {
    std::size_t begin = 0;
    while (begin < due && !is_done_) {
      std::size_t end = begin + 1;
      while (end < pending_.size() && pending_[end].event.depth == pending_[begin].event.depth) ++end;
      settled_depth_ = pending_[begin].event.depth;
      is_done_ = points_.add_point(std::span(pending_).subspan(begin, end - begin));
      begin = end;
    }
    pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(begin));
  }

  const TraceScene& scene_;
  const Directory& directory_;
  FacetTest test_;
  bool has_mailboxes_;
  std::uint64_t longs_;
  std::optional<Piercing> piercing_;  ///< for facet tests in space
  TraceMeters<Count>& meters_;
  RaysMet& met_;
  PointsOfRay<Count> points_;
  std::vector<std::uint32_t> last_ray_;  ///< per facet, the last ray tested against it
  std::uint32_t ray_ = 0;
  std::uint64_t cells_ = 0;
  std::int32_t column_ = 0;
  std::int32_t row_ = 0;
  std::vector<Met> pending_;         ///< known but unprocessed events, sorted
  std::int64_t settled_depth_ = -1;  ///< depth of the last processed events
  bool is_done_ = false;
};

}  // namespace csgsim::software
