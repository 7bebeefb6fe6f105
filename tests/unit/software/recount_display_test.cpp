// Recounts the operations of facet methods from facets on the screen and ray events: facets are scan-converted by
// testing each pixel of their rectangles, and surface sequences are classified by a plain tree.

#include "tests/unit/software/recount_display.h"

#include "sim/software/display/rows.h"
#include "sim/software/rays/tile_planes.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/recount_pixels.h"
#include "tests/unit/software/recount_sequences.h"
#include "tests/unit/software/recount_steps.h"

using namespace csgsim;
using software::DisplayCounts;
using software::Event;
using software::Phase;
using software::ScreenFacet;
using software::VisibleSurface;
using testing::comparisons;
using testing::DisplayRecount;
using testing::FacetEvent;
using testing::FacetScan;
using testing::Operations;
using testing::Scene;
using testing::Sequence;
using testing::SequenceRecount;
using testing::steps;

namespace {

using enum processors::Operation;

/// Sorts the events of a ray, which arrive in facet order.
void count_sort(std::vector<Event>& events, Operations& sum) {
  if (events.size() > 32) {
    std::uint64_t compared = 0;
    std::ranges::sort(events, [&](const Event& a, const Event& b) {
      ++compared;
      return a < b;
    });
    sum += testing::sorted(compared);
    return;
  }
  if (events.empty()) return;
  // Insertion sort: each event passes its larger predecessors and is compared with one that stays.
  std::uint64_t passed = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) passed += events[i] < events[j] ? 1U : 0U;
  }
  sum += (events.size() - 1) * steps({{load_long, 3}, compare_long, branch, {store_long, 2}});
  sum += passed * steps({{load_long, 2}, compare_long, {store_long, 2}, {branch_taken, 2}});
  std::sort(events.begin(), events.end());
}

/// Appends each event to its pixel's list, then reads, sorts and classifies each list.
void recount_depth_lists(DisplayRecount& recount) {
  const std::size_t pixels = recount.rays.size();
  std::vector<std::vector<Event>> lists(pixels);
  recount.of(Phase::initialisation) += steps({{store_long, pixels}});
  Operations& scanning = recount.of(Phase::scan_conversion);
  for (const FacetScan& scan : recount.scans) {
    scanning += testing::conversion(scan, recount.numbers);
    recount.of(Phase::depth_test) += testing::depths(scan.columns, recount.numbers);
    for (const FacetEvent& one : scan.events) lists[recount.pixel(one)].push_back(one.event);
  }
  std::uint64_t events = 0;
  SequenceRecount sequences(recount.tree, recount.primitives, recount.csg);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    std::vector<Event>& list = lists[pixel];
    events += list.size();
    Operations& sorting = recount.of(Phase::sorting);
    sorting += steps({load_long, branch});
    sorting += list.size() * steps({{load_long, 2}, load, store_long, store, branch_taken});
    count_sort(list, sorting);
    std::size_t used = 0;
    recount.seen[pixel] = sequences.along(list, recount.farthest, used, recount.csg);
  }
  scanning += events * steps({load_long, {store_long, 3}, store, {add_long, 2}});
  scanning += steps({{store_long, 2 * pixels}});
  recount.expected.passes = 1;
  recount.expected.pixel_events = events;
  recount.expected.words.pixels += pixels + 3 * events;
  recount.expected.words.sequences = sequences.words();
}

/// Repeated passes over all facets find the next depth of each pixel and collect the events there.
void recount_depth_peeling(DisplayRecount& recount) {
  struct Pixel {
    std::uint32_t least = 0;  ///< depth of the next pass
    std::uint32_t nearest = 0;
    Sequence sequence;
    std::size_t taken = 0;
    bool is_done = false;
  };
  const std::size_t count = recount.rays.size();
  std::vector<Pixel> pixels(count);
  recount.of(Phase::initialisation) += count * steps({{store_long, 3}, store});
  SequenceRecount sequences(recount.tree, recount.primitives, recount.csg);
  Operations& scanning = recount.of(Phase::scan_conversion);
  Operations& testing_depths = recount.of(Phase::depth_test);
  const auto pass = [&](const auto& use) {
    ++recount.expected.passes;
    for (const FacetScan& scan : recount.scans) {
      scanning += testing::conversion(scan, recount.numbers);
      testing_depths += testing::depths(scan.columns, recount.numbers);
      recount.expected.pixel_events += scan.events.size();
      for (const FacetEvent& one : scan.events) use(pixels[recount.pixel(one)], one.event);
    }
  };
  for (bool is_more = true; is_more;) {
    for (Pixel& pixel : pixels) pixel.nearest = recount.farthest;
    pass([&](Pixel& pixel, const Event& event) {
      testing_depths += steps({{load_long, 2}, {compare_long, 2}, branch_taken});
      if (pixel.is_done || event.depth < pixel.least || event.depth >= pixel.nearest) return;
      testing_depths += steps({branch, store_long});
      pixel.nearest = event.depth;
    });
    pass([&](Pixel& pixel, const Event& event) {
      testing_depths += comparisons(1);
      if (pixel.is_done || event.depth != pixel.nearest) return;
      sequences.follow(pixel.sequence, event.primitive(), recount.csg);
      ++pixel.taken;
      scanning += steps({load_long, load, add, store, store_long});
    });
    is_more = false;
    for (std::size_t i = 0; i < count; ++i) {
      Pixel& pixel = pixels[i];
      scanning += steps({load, branch, branch_taken});
      if (pixel.taken == 0) continue;
      ++recount.csg.points;
      pixel.is_done = sequences.is_in(pixel.sequence, pixel.taken, recount.csg);
      is_more = is_more || !pixel.is_done;
      scanning += steps({{store_long, pixel.is_done ? 4U : 2U}, store});
      if (pixel.is_done) recount.seen[i] = {pixel.nearest, sequences.owner(pixel.sequence, pixel.taken, recount.csg)};
      pixel.least = pixel.nearest + 1;
      pixel.taken = 0;
    }
  }
  recount.expected.words.pixels += 4 * count;
  recount.expected.words.sequences = sequences.words();
}

/// Cuts a row where facets begin and end; halves a span unless the order of its surfaces is certain.
class ScanLineRecount {
 public:
  explicit ScanLineRecount(DisplayRecount& recount)
      : recount_(recount), facets_(recount.screen), sequences_(recount.tree, recount.primitives, recount.csg) {}

  void run() {
    for (const ScreenFacet& facet : facets_.facets) {
      sorting() += steps({load, add_long, load_long, {store_long, 2}});
      scanning() += testing::edge_setups(facets_.bounds_of(facet).size(), recount_.numbers);
    }
    std::size_t most = 0;
    const std::size_t height = recount_.scene.view.sampling.height;
    for (std::size_t row = 0; row < height; ++row) most = std::max(most, run_row(static_cast<std::int32_t>(row)));
    recount_.expected.words.buckets = height + facets_.facets.size() + 12 * most;
    recount_.expected.words.sequences = sequences_.words();
  }

 private:
  /// A facet in a row, and its columns.
  struct Part {
    const ScreenFacet* facet;
    std::int32_t first;
    std::int32_t last;
  };
  /// State of a facet over a span by its values at both ends.
  struct Ends {
    bool is_nowhere;
    bool is_everywhere;
    std::int64_t left;
    std::int64_t right;
  };

  Operations& sorting() { return recount_.of(Phase::sorting); }
  Operations& scanning() { return recount_.of(Phase::scan_conversion); }

  /// Returns the active facets.
  std::size_t run_row(std::int32_t row) {
    row_ = row;
    // Facets that begin further up come first.
    std::vector<const ScreenFacet*> active;
    for (const ScreenFacet& facet : facets_.facets) {
      if (facet.pixels.y0 <= row && facet.pixels.y1 >= row) active.push_back(&facet);
    }
    std::ranges::stable_sort(active, {}, [](const ScreenFacet* facet) { return facet->pixels.y0; });
    parts_.clear();
    for (const ScreenFacet* const facet : active) {
      scanning() += testing::row_steps(1, facets_.bounds_of(*facet).size(), recount_.numbers);
      sorting() += steps({load_long, load, compare, branch});
      std::vector<std::int32_t> columns;
      for (std::int32_t column = facet->pixels.x0; column <= facet->pixels.x1; ++column) {
        if (testing::is_within(facets_, *facet, column, row)) columns.push_back(column);
      }
      if (!columns.empty()) parts_.push_back({facet, columns.front(), columns.back()});
    }
    run_spans();
    return active.size();
  }

  void run_spans() {
    std::vector<std::pair<std::int32_t, std::size_t>> limits;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      limits.emplace_back(parts_[i].first, i);
      limits.emplace_back(parts_[i].last + 1, i);
    }
    std::uint64_t compared = 0;
    std::ranges::sort(limits, [&](const auto& a, const auto& b) {
      ++compared;
      return a < b;
    });
    sorting() += compared * steps({{load, 2}, compare, branch_taken, store_long});
    inside_.clear();
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const auto [column, part] = limits[i];
      // The facet is inserted after, or removed from after, the active facets before it.
      const auto before = std::ranges::count_if(inside_, [&, own = part](std::size_t one) { return one < own; });
      sorting() += steps({{load, 1 + static_cast<std::uint64_t>(before)}, compare, branch, store});
      if (std::erase(inside_, part) == 0) inside_.insert(inside_.begin() + before, part);
      const bool is_end = i + 1 == limits.size() || limits[i + 1].first != column;
      if (is_end && !inside_.empty()) run_span(column, limits[i + 1].first - 1);
    }
  }

  void run_span(std::int32_t first, std::int32_t last) {
    ++recount_.expected.spans;
    const VisibleSurface seen = classify(first);
    if (first == last) return fill(first, last, false, seen);
    if (is_sure(first, last, seen.owner != VisibleSurface::nothing_seen))
      return fill(first, last, seen.owner != VisibleSurface::nothing_seen, seen);
    ++recount_.expected.splits;
    const std::int32_t middle = (first + last) / 2;
    run_span(first, middle);
    run_span(middle + 1, last);
  }

  /// Events at a column and the visible surface.
  VisibleSurface classify(std::int32_t column) {
    recount_.of(Phase::depth_test) += testing::depths(inside_.size(), recount_.numbers);
    scanning() += testing::pixel_steps(inside_.size());
    scanning() += (recount_.numbers.longs * inside_.size()) * steps({multiply, load_long});
    left_.clear();
    for (const std::size_t part : inside_) {
      for (const Event& event : recount_.rays.at(column, row_)) {
        if (event.crossing == parts_[part].facet->crossing()) left_.emplace_back(event, part);
      }
    }
    recount_.expected.pixel_events += left_.size();
    std::uint64_t compared = 0;
    std::ranges::sort(left_, [&](const auto& a, const auto& b) {
      ++compared;
      return a.first < b.first;
    });
    sorting() += testing::sorted(compared);
    std::vector<Event> events;
    for (const auto& [event, part] : left_) events.push_back(event);
    return sequences_.along(events, recount_.farthest, used_, recount_.csg);
  }

  /// Computes the value at the right end and compares both values with both ends of the depth range.
  Ends ends_of(const ScreenFacet& facet, std::int32_t first, std::int32_t last) {
    const std::uint64_t longs = recount_.numbers.longs;
    scanning() += longs * steps({multiply, {load_long, 2}, add_long, {store_long, 2}});
    scanning() += steps({{compare_long, 4}, {branch, 4}, store});
    const std::int64_t step = std::int64_t{1} << facets_.fraction_bits;
    const std::int64_t beyond = std::int64_t{facets_.farthest} * step;
    const std::int64_t left = view::value_at(facet.depth, first, row_);
    const std::int64_t right = view::value_at(facet.depth, last, row_);
    const std::int64_t low = std::min(left, right);
    const std::int64_t high = std::max(left, right);
    if (low >= beyond || (facet.leaves && high < step)) return {true, false, left, right};
    if (high < step) return {false, true, 0, 0};  // the whole span is before the near plane
    return {false, low >= step && high < beyond, left, right};
  }

  bool is_behind(const Ends& before, const Ends& behind, bool is_level) {
    const std::uint64_t longs = recount_.numbers.longs;
    scanning() += longs * steps({{load_long, 4}, {add_long, 2}, {compare_long, 2}});
    scanning() += steps({{branch, 2}});
    if (is_level) return before.left == behind.left && before.right == behind.right;
    const std::int64_t step = std::int64_t{1} << facets_.fraction_bits;
    return behind.left - before.left >= step && behind.right - before.right >= step;
  }

  /// Whether each surface up to the visible one covers the whole span behind its predecessor, and all others are absent
  /// or behind it. Stops at the first doubt.
  bool is_sure(std::int32_t first, std::int32_t last, bool is_seen) {
    std::vector<Ends> ends(parts_.size());
    for (const std::size_t part : inside_) ends[part] = ends_of(*parts_[part].facet, first, last);
    for (std::size_t i = 0; i < used_; ++i) {
      const Ends& here = ends[left_[i].second];
      if (!here.is_everywhere) return false;
      if (i == 0) continue;
      const bool is_level = left_[i - 1].first.depth == left_[i].first.depth;
      if (!is_behind(ends[left_[i - 1].second], here, is_level)) return false;
    }
    for (const std::size_t part : inside_) {
      const auto end = left_.begin() + static_cast<std::ptrdiff_t>(used_);
      if (std::find_if(left_.begin(), end, [&](const auto& one) { return one.second == part; }) != end) continue;
      if (ends[part].is_nowhere) continue;
      if (!is_seen || !is_behind(ends[left_[used_ - 1].second], ends[part], false)) return false;
    }
    return true;
  }

  /// Sets pixels to one value or to the depths of a surface.
  void fill(std::int32_t first, std::int32_t last, bool has_surface, const VisibleSurface& seen) {
    const auto columns = static_cast<std::uint64_t>(last - first) + 1;
    scanning() += columns * steps({{store_long, 2}, branch_taken});
    for (std::int32_t column = first; column <= last; ++column) {
      VisibleSurface& pixel = recount_.seen[recount_.pixel({column, row_, {}})];
      pixel = seen;
      if (!has_surface) continue;
      const std::uint32_t crossing = left_[used_ - 1].first.crossing;
      for (const Event& event : recount_.rays.at(column, row_)) {
        if (event.crossing == crossing) pixel.depth = event.depth;
      }
    }
    if (!has_surface) return;
    scanning() += testing::pixel_steps(columns);
    recount_.of(Phase::depth_test) += testing::depths(columns, recount_.numbers);
  }

  DisplayRecount& recount_;
  const software::ScreenFacets& facets_;
  SequenceRecount sequences_;
  std::int32_t row_ = 0;
  std::vector<Part> parts_;
  std::vector<std::size_t> inside_;                    ///< parts over a span
  std::vector<std::pair<Event, std::size_t>> left_{};  ///< events at the left end of a span, with their parts
  std::size_t used_ = 0;                               ///< number of these events up to the visible surface
};

/// A primitive's planes along rows: planes that bound it somewhere in a tile of 64 columns and 16 rows are evaluated at
/// each pixel, keeping the greatest front and the least back.
class PlanesRecount {
 public:
  PlanesRecount(DisplayRecount& recount, std::uint32_t primitive)
      : recount_(recount),
        primitive_(primitive),
        longs_(recount.numbers.longs),
        all_(software::planes_of(recount.scene.tree, recount.scene.geometry, recount.scene.view, primitive)) {}

  void run() {
    const view::PixelRect& pixels = recount_.scene.view.extents[primitive_].pixels;
    if (all_.nowhere || pixels.empty()) return;
    for (std::int32_t top = pixels.y0 / 16 * 16; top <= pixels.y1; top += 16) {
      const std::int32_t first = std::max(top, pixels.y0);
      const std::int32_t last = std::min(top + 15, pixels.y1);
      for (std::int32_t left = pixels.x0; left <= pixels.x1; left += 64)
        run_tile({left, first, std::min(left + 63, pixels.x1), last});
    }
  }

 private:
  Operations& sum() { return recount_.of(Phase::scan_conversion); }

  void run_tile(const view::PixelRect& tile) {
    const std::uint64_t planes = all_.fronts.size() + all_.backs.size();
    // Two products and four values; each is compared with the maximum and the leaders, and stored.
    sum() +=
        (planes * longs_) * steps({{multiply, 2}, {load_long, 11}, {add_long, 6}, {compare_long, 8}, {store_long, 4}});
    sum() += steps({{branch, 8 * planes}});
    software::TilePlanes left;
    software::select_bounding(all_, tile, left);
    for (std::int32_t row = tile.y0; row <= tile.y1; ++row) run_row(tile, row, left);
  }

  void run_row(const view::PixelRect& tile, std::int32_t row, const software::TilePlanes& left) {
    sum() += all_.edges.size() *
             steps({{load_long, 3 * longs_}, {add_long, longs_ + 2}, {divide, 2}, {multiply, 2}, compare, branch});
    const std::uint64_t planes = left.fronts.size() + left.backs.size();
    sum() += (planes * longs_) * steps({{load_long, 2}, add_long, store_long});
    for (std::int32_t column = tile.x0; column <= tile.x1; ++column) {
      const bool is_within = std::ranges::all_of(all_.edges, [&](const software::TilePlanes::Edge& edge) {
        return (view::value_at(edge.linear, column, row) >= 0) == edge.positive;
      });
      if (!is_within) continue;
      sum() += planes * steps({{load_long, longs_}, {compare_long, longs_}, {add_long, longs_}, branch, branch_taken});
      run_pixel(column, row, left);
    }
  }

  void run_pixel(std::int32_t column, std::int32_t row, const software::TilePlanes& left) {
    const auto replaced = [&](const std::vector<view::FixedLinear>& planes, std::int64_t sign) {
      std::uint64_t times = 0;
      std::optional<std::int64_t> greatest;
      for (const view::FixedLinear& plane : planes) {
        const std::int64_t value = sign * view::value_at(plane, column, row);
        if (greatest && value <= *greatest) continue;
        greatest = value;
        ++times;
      }
      return times;
    };
    sum() += steps({{store_long, longs_ * (replaced(left.fronts, 1) + replaced(left.backs, -1))}});
    sum() += (2 * longs_) * steps({shift_long, {shifted_bit, recount_.numbers.fraction_bits}, load_long});
    sum() += steps({{compare_long, 3}, {branch, 3}});
    for (const Event& event : recount_.rays.at(column, row)) {
      if (event.crossing != 2 * primitive_) continue;
      // An interval is stored, then counted and copied to its ray's list.
      sum() += steps({{store_long, 2}, store});
      sum() += steps({{load, 3}, {load_long, 4}, {add_long, 4}, store, {store_long, 4}, {branch_taken, 2}});
    }
  }

  DisplayRecount& recount_;
  std::uint32_t primitive_;
  std::uint64_t longs_;
  software::TilePlanes all_;
};

/// Transforms half-spaces into the picture; sorts events by ray and classifies them by the list structure.
void recount_rays(DisplayRecount& recount) {
  const std::size_t pixels = recount.rays.size();
  const std::uint64_t planes = recount.scene.geometry.halfspaces();
  recount.of(Phase::transformation) =
      planes *
      steps(
          {{multiply, 16 * 4 + 3 * 2}, {divide, 3 * 2}, {add_long, 12 * 4 + 3 * 2}, {load_long, 20}, {store_long, 6}});
  recount.of(Phase::transformation) += testing::calls(planes);
  recount.of(Phase::initialisation) = steps({{store_long, 2 * pixels}});
  for (std::uint32_t primitive = 0; primitive < recount.primitives; ++primitive)
    PlanesRecount(recount, primitive).run();
  SequenceRecount sequences(recount.tree, recount.primitives, recount.csg, testing::Evaluate::along);
  Operations& sorting = recount.of(Phase::sorting);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    // Primitives in order, each with its entry and its exit.
    std::vector<Event> events(recount.rays.at(pixel).begin(), recount.rays.at(pixel).end());
    std::ranges::sort(events, {}, &Event::crossing);
    for (const Event& event : events) {
      if (event.leaves()) continue;
      sorting += steps({{load_long, 2}, load, {store_long, 2}, {store, 2}});
    }
    count_sort(events, sorting);
    std::size_t used = 0;
    recount.seen[pixel] = sequences.along(events, recount.farthest, used, recount.csg);
  }
  DisplayCounts& expected = recount.expected;
  expected.drawn_polygons = expected.polygons;
  expected.pixel_events = recount.rays.all();
  expected.words.polygons = 6 * planes;
  expected.words.sequences = sequences.words();
}

/// Returns the method's own counts.
DisplayCounts check_method(const Scene& scene, const std::string& method) {
  CAPTURE(method);
  DisplayRecount recount(scene);
  if (method == "depth-lists") recount_depth_lists(recount);
  if (method == "depth-peeling") recount_depth_peeling(recount);
  if (method == "scan-line") ScanLineRecount(recount).run();
  if (method == "rays") recount_rays(recount);
  const software::Displayed found = recount.by(method);
  recount.check(found);
  return found.counts;
}

}  // namespace

TEST_CASE("facet methods count as a plain recount does on random scenes") {
  std::uint64_t scenes = 0;
  std::uint64_t passes = 0;
  std::uint64_t splits = 0;
  std::uint64_t ties = 0;
  for (std::uint64_t seed = 1; scenes < 150; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    CAPTURE(seed);
    ++scenes;
    ties += check_method(*scene, "depth-lists").csg.ties;
    passes += check_method(*scene, "depth-peeling").passes;
    splits += check_method(*scene, "scan-line").splits;
    check_method(*scene, "rays");
  }
  CHECK(passes > 3 * scenes);
  CHECK(splits > scenes);
  CHECK(ties > scenes);
}
TEST_CASE("facet methods count as a plain recount does on the thesis's objects") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    const Scene scene = testing::thesis_scene(one, 48, 36);
    for (const char* const method : {"depth-lists", "depth-peeling", "scan-line", "rays"}) check_method(scene, method);
  }
}
