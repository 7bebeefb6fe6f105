#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/coherences/sequences.h"
#include "sim/software/display/common.h"
#include "sim/software/display/rows.h"
#include "sim/software/display/scan.h"
#include "sim/software/rays/sort_events.h"

namespace csgsim::software {

namespace {

/// The surfaces of all pixels, as a linked list per pixel; the last added is the first.
class PixelLists {
 public:
  explicit PixelLists(std::size_t pixels) : heads_(pixels, none) {}

  template <class Count>
  void add(std::size_t pixel, const Event& event, Count& count) {
    elements_.push_back({event, heads_[pixel]});
    heads_[pixel] = static_cast<std::uint32_t>(elements_.size() - 1);
    count(Operation::load_long);
    count(Operation::store_long, 3);
    count(Operation::store);
    count(Operation::add_long, 2);
  }

  /// Copies the surfaces of a pixel to `events` in the order in which they were added.
  template <class Count>
  void gather(std::size_t pixel, std::vector<Event>& events, Count& count) const {
    events.clear();
    for (std::uint32_t at = heads_[pixel]; at != none; at = elements_[at].next) events.push_back(elements_[at].event);
    std::ranges::reverse(events);
    count(Operation::load_long, 1 + 2 * events.size());
    count(Operation::load, events.size());
    count(Operation::store_long, events.size());
    count(Operation::store, events.size());
    count(Operation::branch_taken, events.size());
    count(Operation::branch);
  }

  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  /// An element has a depth, a surface and a pointer.
  [[nodiscard]] std::uint64_t words() const { return heads_.size() + 3 * elements_.size(); }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Element {
    Event event;
    std::uint32_t next;
  };

  std::vector<std::uint32_t> heads_;
  std::vector<Element> elements_;
};

template <class Count>
void draw_by_lists(const DisplaySubject& subject, const ScreenFacets& seen, Ledger<Count>& ledger, Displayed& result) {
  const std::uint64_t longs = longs_of(subject.view.sampling);
  const std::size_t width = subject.view.sampling.width;
  PixelLists lists(subject.pixels());
  ledger[Phase::initialisation](Operation::store_long, subject.pixels());
  Count& scanning = ledger[Phase::scan_conversion];
  for (const ScreenFacet& facet : seen.facets) {
    scan(seen, facet, longs, ledger, true, [&](std::int32_t column, std::int32_t row, const Event& event) {
      lists.add(static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column), event, scanning);
    });
  }
  Sequences<Count> sequences(subject.tree, scanning);
  std::vector<Event> events;
  for (std::size_t pixel = 0; pixel < subject.pixels(); ++pixel) {
    Count& sorting = ledger[Phase::sorting];
    lists.gather(pixel, events, sorting);
    if (events.size() > max_inserted) {
      standard_sort(std::span(events), sorting);
    } else {
      insertion_sort(std::span(events), sorting);
    }
    result.picture.seen[pixel] = sequences.along(events, subject.farthest(), scanning);
    scanning(Operation::store_long, 2);
  }
  result.counts.passes = 1;
  result.counts.pixel_events = lists.size();
  result.counts.words.pixels += lists.words();
  result.counts.words.sequences = sequences.words();
}

Displayed run_depth_lists(const DisplaySubject& subject, bool counts) {
  const auto draw = [&](const ScreenFacets& seen, auto& ledger, Displayed& result) {
    draw_by_lists(subject, seen, ledger, result);
  };
  return counts ? display_facets<CountingMethod>(subject, draw) : display_facets<UncountedMethod>(subject, draw);
}

}  // namespace

extern const DisplayRow depth_lists_row{.name = "depth-lists",
                                        .help = "stores, sorts and classifies all depths of a pixel",
                                        .source = "Jansen 1987, 2.4.1 and 6.1",
                                        .run = run_depth_lists};

}  // namespace csgsim::software
