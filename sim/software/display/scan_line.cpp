#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/software/coherences/sequences.h"
#include "sim/software/display/common.h"
#include "sim/software/display/rows.h"
#include "sim/software/display/scan.h"
#include "sim/software/rays/sort_events.h"

namespace csgsim::software {

namespace {

/// A facet in a row, where its depth is a linear function of the column.
struct ActiveFacet {
  const ScreenFacet* facet = nullptr;
  std::int64_t at_start = 0;  ///< depth at column 0 of the row, with fraction bits

  [[nodiscard]] std::int64_t value(std::int32_t column) const { return at_start + facet->depth.a * column; }
};

/// Certainty about the events of a facet over a span.
enum class Presence : std::uint8_t {
  none,       ///< no event anywhere
  somewhere,  ///< possibly some events
  all,        ///< an event at every pixel
};

/// A facet over a span.
struct OverSpan {
  Presence presence = Presence::somewhere;
  std::int64_t left = 0;  ///< depths at the ends, with fraction bits; both 0 if the depth step is 0 throughout
  std::int64_t right = 0;
};

/// An event at the left end of a span, and its facet.
struct LeftEvent {
  Event event;
  std::size_t active;
};

/// Draws a picture row by row. Within a span in which the same facets are active and their order is certain and equal
/// at both ends, the surface visible at one end is visible throughout.
template <class Count>
class ScanLines {
 public:
  ScanLines(const DisplaySubject& subject, const ScreenFacets& seen, Ledger<Count>& ledger, Displayed& result)
      : subject_(subject),
        facets_(seen),
        ledger_(ledger),
        result_(result),
        sequences_(subject.tree, ledger[Phase::scan_conversion]),
        longs_(longs_of(subject.view.sampling)),
        step_(std::int64_t{1} << seen.fraction_bits),
        beyond_(static_cast<std::int64_t>(seen.farthest) << seen.fraction_bits) {}

  void draw() {
    const std::vector<std::vector<const ScreenFacet*>> buckets = bucketed();
    std::vector<const ScreenFacet*> active;
    std::size_t max_active = 0;
    for (std::uint32_t row = 0; row < subject_.view.sampling.height; ++row) {
      active.insert(active.end(), buckets[row].begin(), buckets[row].end());
      std::erase_if(active, [&](const ScreenFacet* one) { return one->pixels.y1 < static_cast<std::int32_t>(row); });
      max_active = std::max(max_active, active.size());
      row_ = static_cast<std::int32_t>(row);
      draw_row(active);
    }
    result_.counts.words.buckets = buckets.size() + facets_.facets.size() + 12 * max_active;
    result_.counts.words.sequences = sequences_.words();
  }

 private:
  /// The facets that begin in each row.
  std::vector<std::vector<const ScreenFacet*>> bucketed() {
    std::vector<std::vector<const ScreenFacet*>> buckets(subject_.view.sampling.height);
    Count& count = ledger_[Phase::sorting];
    for (const ScreenFacet& facet : facets_.facets) {
      buckets[static_cast<std::size_t>(facet.pixels.y0)].push_back(&facet);
      count(Operation::load);
      count(Operation::add_long);
      count(Operation::load_long);
      count(Operation::store_long, 2);
      count_edges(ledger_[Phase::scan_conversion], facets_.bounds_of(facet).size(), longs_);
    }
    return buckets;
  }

  /// Splits the row at columns where a facet begins or ends; the active facets are constant in between.
  void draw_row(std::span<const ScreenFacet* const> active) {
    begin_row(active);
    inside_.clear();
    for (std::size_t i = 0; i < limits_.size();) {
      const std::int32_t column = limits_[i].first;
      for (; i < limits_.size() && limits_[i].first == column; ++i) enter_or_leave(limits_[i].second);
      if (inside_.empty()) continue;
      draw_span({column, limits_[i].first - 1});
    }
  }

  void begin_row(std::span<const ScreenFacet* const> active) {
    Count& scanning = ledger_[Phase::scan_conversion];
    Count& sorting = ledger_[Phase::sorting];
    active_.clear();
    limits_.clear();
    for (const ScreenFacet* const facet : active) {
      count_next_row(scanning, facets_.bounds_of(*facet).size(), longs_);
      sorting(Operation::load_long);
      sorting(Operation::load);
      sorting(Operation::compare);
      sorting(Operation::branch);
      const Span span = facets_.span_of(*facet, row_);
      if (span.empty()) continue;
      limits_.emplace_back(span.first, active_.size());
      limits_.emplace_back(span.last + 1, active_.size());
      active_.push_back({facet, value_at(facet->depth, 0, row_)});
    }
    std::ranges::sort(limits_, [&](const auto& a, const auto& b) {
      sorting(Operation::load, 2);
      sorting(Operation::compare);
      sorting(Operation::branch_taken);
      sorting(Operation::store_long);
      return a < b;
    });
  }

  void enter_or_leave(std::size_t active) {
    Count& count = ledger_[Phase::sorting];
    count(Operation::load);
    count(Operation::compare);
    count(Operation::branch);
    const auto place = std::ranges::lower_bound(inside_, active);
    count(Operation::load, static_cast<std::uint64_t>(place - inside_.begin()));
    count(Operation::store);
    if (place != inside_.end() && *place == active) {
      inside_.erase(place);
    } else {
      inside_.insert(place, active);
    }
  }

  void draw_span(Span span) {
    ++result_.counts.spans;
    const VisibleSurface seen = seen_at(span.first);
    if (span.columns() == 1) return fill(span, seen, nullptr);
    const ActiveFacet* surface = nullptr;
    if (is_sure(span, seen, surface)) return fill(span, seen, surface);
    ++result_.counts.splits;
    const std::int32_t middle = span.first + (span.last - span.first) / 2;
    draw_span({span.first, middle});
    draw_span({middle + 1, span.last});
  }

  /// Collects the sorted events at the left end, and returns the visible surface.
  VisibleSurface seen_at(std::int32_t column) {
    Count& scanning = ledger_[Phase::scan_conversion];
    left_.clear();
    for (const std::size_t active : inside_) {
      const ActiveFacet& one = active_[active];
      count_depths(ledger_[Phase::depth_test], 1, facets_.fraction_bits, longs_);
      count_columns(scanning, 1);
      scanning(Operation::multiply, longs_);
      scanning(Operation::load_long, longs_);
      const std::optional<Event> event = facets_.event_at(*one.facet, column, row_, one.value(column));
      if (event) left_.push_back({*event, active});
    }
    result_.counts.pixel_events += left_.size();
    std::ranges::sort(left_, [&](const LeftEvent& a, const LeftEvent& b) {
      Count& sorting = ledger_[Phase::sorting];
      sorting(Operation::load_long, 2);
      sorting(Operation::compare_long);
      sorting(Operation::branch_taken);
      sorting(Operation::store_long);
      return a.event < b.event;
    });
    events_.clear();
    for (const LeftEvent& one : left_) events_.push_back(one.event);
    return sequences_.along(events_, facets_.farthest, scanning, &seen_by_);
  }

  /// Whether the order of the surfaces up to the visible one is certain throughout the span. `surface` is set to the
  /// visible one, if any. The order includes that a ray leaves a primitive at least a step behind entering it, so that
  /// the primitive is never too thin to be hit.
  bool is_sure(Span span, const VisibleSurface& seen, const ActiveFacet*& surface) {
    over_.assign(active_.size(), {});
    for (const std::size_t active : inside_) over_[active] = over(active_[active], span);
    const OverSpan* last = nullptr;
    for (std::size_t i = 0; i < seen_by_; ++i) {
      const OverSpan& here = over_[left_[i].active];
      if (here.presence != Presence::all) return false;
      if (last != nullptr && !follows(*last, here, events_[i - 1].depth == events_[i].depth)) return false;
      last = &here;
    }
    const bool is_seen = seen.depth != facets_.farthest;
    if (is_seen) surface = &active_[left_[seen_by_ - 1].active];
    return is_rest_behind(is_seen ? last : nullptr);
  }

  /// Whether `here` is level with `before`, or at least a step behind it, at both ends.
  bool follows(const OverSpan& before, const OverSpan& here, bool is_level) {
    Count& count = ledger_[Phase::scan_conversion];
    count(Operation::load_long, 4 * longs_);
    count(Operation::add_long, 2 * longs_);
    count(Operation::compare_long, 2 * longs_);
    count(Operation::branch, 2);
    if (is_level) return before.left == here.left && before.right == here.right;
    return here.left >= before.left + step_ && here.right >= before.right + step_;
  }

  /// Whether all other facets are behind the visible surface, or have no events.
  bool is_rest_behind(const OverSpan* seen) {
    for (std::size_t i = 0; i < seen_by_; ++i) over_[left_[i].active].presence = Presence::none;
    return std::ranges::all_of(inside_, [&](std::size_t active) {
      const OverSpan& here = over_[active];
      return here.presence == Presence::none || (seen != nullptr && follows(*seen, here, false));
    });
  }

  OverSpan over(const ActiveFacet& active, Span span) {
    const ScreenFacet& facet = *active.facet;
    OverSpan over{Presence::all, active.value(span.first), active.value(span.last)};
    count_ends();
    const auto both = [&](const auto& holds) { return holds(over.left) && holds(over.right); };
    if (both([&](std::int64_t value) { return value >= beyond_; })) return {Presence::none};
    if (!both([&](std::int64_t value) { return value < beyond_; })) over.presence = Presence::somewhere;
    if (both([&](std::int64_t value) { return value < step_; })) {
      if (facet.leaves) return {Presence::none};
      over.left = over.right = 0;
    } else if (!both([&](std::int64_t value) { return value >= step_; })) {
      over.presence = Presence::somewhere;
    }
    return over;
  }

  /// Counts the value of a facet at the right end of a span, given the left one, and its classification.
  void count_ends() {
    Count& count = ledger_[Phase::scan_conversion];
    count(Operation::multiply, longs_);
    count(Operation::load_long, 2 * longs_);
    count(Operation::add_long, longs_);
    count(Operation::compare_long, 4);
    count(Operation::branch, 4);
    count(Operation::store_long, 2 * longs_);
    count(Operation::store);
  }

  /// Sets the pixels of a span: all equal, or at the depths of a surface.
  void fill(const Span& span, const VisibleSurface& seen, const ActiveFacet* surface) {
    Count& count = ledger_[Phase::scan_conversion];
    const auto columns = static_cast<std::uint64_t>(span.columns());
    count(Operation::store_long, 2 * columns);
    count(Operation::branch_taken, columns);
    VisibleSurface* pixel = &result_.picture.seen[static_cast<std::size_t>(row_) * subject_.view.sampling.width +
                                                  static_cast<std::size_t>(span.first)];
    if (surface == nullptr) {
      std::fill_n(pixel, columns, seen);
      return;
    }
    count_columns(count, columns);
    count_depths(ledger_[Phase::depth_test], columns, facets_.fraction_bits, longs_);
    std::int64_t value = surface->value(span.first);
    for (std::uint64_t i = 0; i < columns; ++i, value += surface->facet->depth.a)
      pixel[i] = {static_cast<std::uint32_t>(std::max<std::int64_t>(0, value >> facets_.fraction_bits)), seen.owner};
  }

  const DisplaySubject& subject_;
  const ScreenFacets& facets_;
  Ledger<Count>& ledger_;
  Displayed& result_;
  Sequences<Count> sequences_;
  std::uint64_t longs_;  ///< longs per value
  std::int64_t step_;    ///< depth step, with fraction bits
  std::int64_t beyond_;  ///< farthest depth, with fraction bits
  std::int32_t row_ = 0;
  std::vector<ActiveFacet> active_;                           ///< facets with columns in this row
  std::vector<std::pair<std::int32_t, std::size_t>> limits_;  ///< columns at which an active facet begins or has ended
  std::vector<std::size_t> inside_;                           ///< active facets in the columns between two limits
  std::vector<LeftEvent> left_;                               ///< events at the left end of a span
  std::vector<Event> events_;                                 ///< the events of left_, without facets
  std::size_t seen_by_ = 0;                                   ///< number of these events up to the visible one
  std::vector<OverSpan> over_;                                ///< indexed by active facet
};

Displayed run_scan_line(const DisplaySubject& subject, bool counts) {
  const auto draw = [&]<class Count>(const ScreenFacets& seen, Ledger<Count>& ledger, Displayed& result) {
    ScanLines<Count>(subject, seen, ledger, result).draw();
  };
  return counts ? display_facets<CountingMethod>(subject, draw) : display_facets<UncountedMethod>(subject, draw);
}

}  // namespace

extern const DisplayRow scan_line_row{
    .name = "scan-line",
    .help = "splits a row where facets begin and end, and compares their order at the ends of spans",
    .source = "Atherton 1983",
    .run = run_scan_line};

}  // namespace csgsim::software
