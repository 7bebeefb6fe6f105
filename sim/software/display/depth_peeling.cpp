#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/software/coherences/sequences.h"
#include "sim/software/display/common.h"
#include "sim/software/display/rows.h"
#include "sim/software/display/scan.h"

namespace csgsim::software {

namespace {

/// Peels one layer of surfaces after another off all pixels: a first pass over the facets finds the nearest depth
/// behind the previous layer, a second one processes all surfaces at that depth.
template <class Count>
class Peeling {
 public:
  Peeling(const DisplaySubject& subject, const ScreenFacets& seen, Ledger<Count>& ledger, Displayed& result)
      : subject_(subject),
        facets_(seen),
        ledger_(ledger),
        result_(result),
        sequences_(subject.tree, ledger[Phase::scan_conversion]),
        pixels_(subject.pixels(), Pixel{subject.farthest()}) {
    ledger[Phase::initialisation](Operation::store_long, 3 * pixels_.size());
    ledger[Phase::initialisation](Operation::store, pixels_.size());
  }

  void draw() {
    do {
      for_each_event([&](Pixel& pixel, const Event& event) { find_nearest(pixel, event); });
      for_each_event([&](Pixel& pixel, const Event& event) { add_event(pixel, event); });
    } while (end_layer());
    result_.counts.words.pixels += 4 * pixels_.size();
    result_.counts.words.sequences = sequences_.words();
  }

 private:
  /// Depths below `min_depth` are already processed; `nearest` is the minimum found for the current layer.
  struct Pixel {
    std::uint32_t nearest;
    std::uint32_t min_depth = 0;
    std::uint32_t element = Sequences<Count>::none;
    std::uint32_t taken = 0;
  };

  template <class Use>
  void for_each_event(const Use& use) {
    const std::uint64_t longs = longs_of(subject_.view.sampling);
    const std::size_t width = subject_.view.sampling.width;
    ++result_.counts.passes;
    for (const ScreenFacet& facet : facets_.facets) {
      scan(facets_, facet, longs, ledger_, true, [&](std::int32_t column, std::int32_t row, const Event& event) {
        ++result_.counts.pixel_events;
        use(pixels_[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)], event);
      });
    }
  }

  void find_nearest(Pixel& pixel, const Event& event) {
    Count& count = ledger_[Phase::depth_test];
    count(Operation::load_long, 2);
    count(Operation::compare_long, 2);
    count(Operation::branch_taken);
    if (event.depth < pixel.min_depth || event.depth >= pixel.nearest) return;
    pixel.nearest = event.depth;
    count(Operation::branch);
    count(Operation::store_long);
  }

  void add_event(Pixel& pixel, const Event& event) {
    ledger_[Phase::depth_test](Operation::load_long);
    ledger_[Phase::depth_test](Operation::compare_long);
    ledger_[Phase::depth_test](Operation::branch);
    if (event.depth != pixel.nearest) return;
    Count& count = ledger_[Phase::scan_conversion];
    count(Operation::load_long);
    pixel.element = sequences_.after(pixel.element, event.primitive(), count);
    ++pixel.taken;
    count(Operation::load);
    count(Operation::add);
    count(Operation::store);
    count(Operation::store_long);
  }

  /// Classifies the current layer; returns whether some pixel needs further layers.
  bool end_layer() {
    bool is_more = false;
    Count& count = ledger_[Phase::scan_conversion];
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      Pixel& pixel = pixels_[i];
      count(Operation::load);
      count(Operation::branch);
      count(Operation::branch_taken);
      if (pixel.taken == 0) continue;
      count.point();
      const bool is_in = sequences_.is_in(pixel.element, pixel.taken, count);
      if (is_in) {
        result_.picture.seen[i] = {pixel.nearest, sequences_.owner(pixel.element, pixel.taken, count)};
        count(Operation::store_long, 2);
      }
      is_more = is_more || !is_in;
      pixel.min_depth = is_in ? subject_.farthest() : pixel.nearest + 1;
      pixel.nearest = subject_.farthest();
      pixel.taken = 0;
      count(Operation::store_long, 2);
      count(Operation::store);
    }
    return is_more;
  }

  const DisplaySubject& subject_;
  const ScreenFacets& facets_;
  Ledger<Count>& ledger_;
  Displayed& result_;
  Sequences<Count> sequences_;
  std::vector<Pixel> pixels_;
};

Displayed run_depth_peeling(const DisplaySubject& subject, bool counts) {
  const auto draw = [&]<class Count>(const ScreenFacets& seen, Ledger<Count>& ledger, Displayed& result) {
    Peeling<Count>(subject, seen, ledger, result).draw();
  };
  return counts ? display_facets<CountingMethod>(subject, draw) : display_facets<UncountedMethod>(subject, draw);
}

}  // namespace

extern const DisplayRow depth_peeling_row{
    .name = "depth-peeling",
    .help = "peels the nearest surfaces off all pixels, in passes over all facets, until the pixels are inside",
    .source = "Everitt 2001",
    .run = run_depth_peeling};

}  // namespace csgsim::software
