#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/view/projection.h"
#include "hw/base/seconds.h"
#include "sim/software/coherences/sequences.h"
#include "sim/software/display/common.h"
#include "sim/software/display/depth_order.h"
#include "sim/software/display/faults.h"
#include "sim/software/display/polygons.h"
#include "sim/software/display/real_depths.h"
#include "sim/software/display/rows.h"
#include "sim/software/display/scan.h"
#include "sim/software/display/screen_pieces.h"
#include "sim/software/rays/caster.h"

namespace csgsim::software {

namespace {

/// Progress of a pixel in the order of surfaces.
struct PriorityPixel {
  std::uint32_t element = 0;
  std::uint32_t depth = 0;  ///< depth of the last surface; only with a depth buffer
  std::uint32_t level = 0;  ///< number of surfaces at that depth
  bool is_set = false;
};

/// Draws polygons from front to back and sets a pixel once, when a polygon enters the solid (thesis, algorithm 5.2).
/// If has_depth_buffer, a surface at the depth of the last one is processed together with it, and a surface before the
/// last one is swapped with it.
template <class Count, bool has_depth_buffer>
class ListPriority {
 public:
  ListPriority(const DisplaySubject& subject, Ledger<Count>& ledger, Displayed& result)
      : subject_(subject),
        ledger_(ledger),
        result_(result),
        sequences_(subject.tree, ledger[Phase::scan_conversion]),
        pixels_(subject.pixels(), PriorityPixel{Sequences<Count>::none}) {
    ledger[Phase::initialisation](Operation::store_long, (has_depth_buffer ? 2 : 1) * pixels_.size());
    if (has_depth_buffer) ledger[Phase::initialisation](Operation::store, pixels_.size());
    if constexpr (Count::counts) drawn_.resize(pixels_.size());
  }

  void draw(const Polygons& polygons, const ScreenFacets& seen) {
    const view::EyeSpace eye = view::eye_space(subject_.view.camera, subject_.view.sampling);
    const CellOrder order = order_front_to_back(polygons, eye, subject_.geometry.planes.centre(),
                                                subject_.view.sampling.width, subject_.view.sampling.height);
    screen_ = screen_pieces(polygons, order.cells, seen, subject_.geometry, subject_.view);
    count_retrieval(order);
    count_pieces(polygons, order, seen, screen_);
    // Near caps, where rays start inside a primitive, precede all polygons.
    for (const ScreenFacet& facet : seen.facets) {
      if (facet.facet != ScreenFacet::near_cap) continue;
      draw_piece(seen, facet);
      near_caps_.push_back(facet.primitive);
    }
    const std::uint64_t longs = longs_of(subject_.view.sampling);
    DepthOrder<Count> sorted(screen_.pieces, longs, ledger_[Phase::sorting]);
    for (std::size_t cell = 0; cell + 1 < screen_.begins.size(); ++cell) {
      for (const std::uint32_t piece : sorted.sorted_pieces(screen_.begins[cell], screen_.begins[cell + 1]))
        draw_piece(screen_.pieces, screen_.pieces.facets[piece]);
    }
    add_counts(polygons, order, screen_);
    result_.counts.conflicts = sorted.conflicts();
  }

  /// Counts the wrong pixels by cause.
  void judge() {
    const RayCaster rays(subject_.model, subject_.geometry, subject_.view);
    UncountedMethod uncounted;
    Sequences<UncountedMethod> exact(subject_.tree, uncounted);
    const RealDepths real(subject_.geometry, subject_.view);
    std::vector<Event> events;
    std::vector<double> depths;
    RayBand band;
    for (std::uint32_t row = 0; row < rays.height(); row += band_rows) {
      rays.cast(row, band);
      for (std::size_t ray = 0; ray < band.rays(); ++ray) {
        const std::size_t pixel = std::size_t{row} * rays.width() + ray;
        const VisibleSurface expected = exact.along(band.events_of(ray), rays.farthest(), uncounted);
        if (expected == result_.picture.seen[pixel]) continue;
        const auto column = static_cast<std::uint32_t>(pixel % rays.width());
        const auto at = static_cast<std::uint32_t>(pixel / rays.width());
        events.clear();
        depths.clear();
        for (const Event& event : band.events_of(ray)) {
          if (!is_drawn(event, column, at)) continue;
          events.push_back(event);
          depths.push_back(real.depth_of(event.crossing, column, at));
        }
        const bool has_lost = events.size() < band.events_of(ray).size();
        result_.faults.add(fault_of({events, depths, real.rounding(column, at), has_lost}, drawn_[pixel]));
      }
    }
  }

 private:
  [[nodiscard]] bool is_drawn(const Event& event, std::uint32_t column, std::uint32_t row) const {
    const auto x = static_cast<std::int32_t>(column);
    const auto y = static_cast<std::int32_t>(row);
    const bool enters_before = event.depth == 0 && event.crossing == 2 * event.primitive();
    return (enters_before && std::ranges::find(near_caps_, event.primitive()) != near_caps_.end()) ||
           std::ranges::any_of(screen_.pieces.facets, [&](const ScreenFacet& piece) {
             return piece.crossing() == event.crossing && screen_.pieces.event_at(piece, x, y) == event;
           });
  }

  /// Per cell: the eye's side of a wall, four sides of the view at eight corners, and the box.
  void count_retrieval(const CellOrder& order) {
    Count& count = ledger_[Phase::sorting];
    const std::uint64_t cells = order.looked_at;
    count(Operation::load_long, 8 * cells);
    count(Operation::compare_long, (1 + 32) * cells);
    count(Operation::multiply, 4 * 24 * cells);
    count(Operation::add_long, 4 * 30 * cells);
    count(Operation::branch, (1 + 32) * cells);
    count(Operation::store_long, 2 * order.cells.size());
  }

  /// Corners and edges are those of pieces in drawn cells; planes are those of facets.
  void count_pieces(const Polygons& polygons, const CellOrder& order, const ScreenFacets& seen,
                    const ScreenPieces& screen) {
    std::uint64_t corners = 0;
    for (const std::uint32_t cell : order.cells) {
      for (const Piece& piece : polygons.cells[cell].bucket) corners += piece.corners.size();
    }
    ledger_[Phase::transformation] = {};
    count_transformation(corners, seen.facets.size(), screen.pieces.linears.size(), ledger_[Phase::transformation]);
  }

  void add_counts(const Polygons& polygons, const CellOrder& order, const ScreenPieces& screen) {
    DisplayCounts& counts = result_.counts;
    counts.pieces = polygons.clipped;
    counts.shared = polygons.shared;
    counts.crossing_tests = polygons.crossing_tests;
    counts.overlap_tests = polygons.overlap_tests;
    counts.drawn_polygons = screen.pieces.facets.size();
    counts.cells = polygons.filled_cells();
    counts.drawn_cells = order.cells.size();
    counts.visited_parts = order.looked_at;
    std::uint64_t corners = 0;
    for (const PolygonCell& cell : polygons.cells) {
      if (cell.bucket.size() > subject_.bucket_size) ++counts.overfull_cells;
      counts.references += cell.bucket.size();
      for (const Piece& piece : cell.bucket) corners += piece.corners.size();
    }
    // A corner has three coordinates, a piece its facet and box, and a plane in the picture three coefficients of two
    // longs.
    counts.words.polygons =
        3 * corners + 8 * counts.references + 6 * screen.pieces.linears.size() + 10 * counts.drawn_polygons;
    counts.words.buckets = polygons.words;
    counts.words.pixels += (has_depth_buffer ? 3 : 1) * pixels_.size();
    counts.words.sequences = sequences_.words();
  }

  void draw_piece(const ScreenFacets& facets, const ScreenFacet& facet) {
    const std::size_t width = subject_.view.sampling.width;
    const std::uint64_t longs = longs_of(subject_.view.sampling);
    scan(facets, facet, longs, ledger_, has_depth_buffer,
         [&](std::int32_t column, std::int32_t row, const Event& event) {
           ++result_.counts.pixel_events;
           const std::size_t pixel = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
           if constexpr (has_depth_buffer) {
             draw_by_depth(pixels_[pixel], result_.picture.seen[pixel], event);
           } else {
             draw_next(pixels_[pixel], result_.picture.seen[pixel], event);
           }
         });
  }

  void draw_next(PriorityPixel& pixel, VisibleSurface& seen, const Event& event) {
    Count& count = ledger_[Phase::scan_conversion];
    count(Operation::load_long);
    count(Operation::branch);
    if (pixel.is_set) return;
    advance(pixel, event);
    classify(pixel, seen, event.primitive(), 1);
  }

  void advance(PriorityPixel& pixel, const Event& event) {
    Count& count = ledger_[Phase::scan_conversion];
    pixel.element = sequences_.after(pixel.element, event.primitive(), count);
    pixel.depth = event.depth;
    pixel.level = 1;
    count(Operation::store_long);
    if constexpr (Count::counts) drawn_[static_cast<std::size_t>(&pixel - pixels_.data())].push_back(event);
  }

  /// Sets the pixel if the point behind its last surfaces is inside, and otherwise clears it. The last `at` surfaces
  /// are at the pixel's depth.
  void classify(PriorityPixel& pixel, VisibleSurface& seen, std::uint32_t primitive, std::size_t at) {
    Count& count = ledger_[Phase::scan_conversion];
    count.point();
    pixel.is_set = sequences_.is_in(pixel.element, at, count);
    if (pixel.is_set) {
      seen = {pixel.depth, at == 1 ? primitive : sequences_.owner(pixel.element, at, count)};
      count(Operation::store_long, has_depth_buffer ? 2 : 1);
    } else {
      seen = {subject_.farthest(), VisibleSurface::nothing_seen};
    }
  }

  void draw_by_depth(PriorityPixel& pixel, VisibleSurface& seen, const Event& event) {
    Count& testing = ledger_[Phase::depth_test];
    testing(Operation::load_long);
    testing(Operation::compare_long);
    testing(Operation::branch, 2);
    if (pixel.element == Sequences<Count>::none || event.depth > pixel.depth) {
      testing(Operation::store_long);
      draw_next(pixel, seen, event);
    } else if (event.depth == pixel.depth) {
      join(pixel, seen, event);
    } else {
      exchange(pixel, seen, event);
    }
  }

  /// Adds a surface at the same depth as the last ones.
  void join(PriorityPixel& pixel, VisibleSurface& seen, const Event& event) {
    const std::size_t level = pixel.level + 1;
    advance(pixel, event);
    pixel.level = static_cast<std::uint32_t>(level);
    classify(pixel, seen, event.primitive(), level);
  }

  /// Swaps a surface with the last one, which is behind it.
  void exchange(PriorityPixel& pixel, VisibleSurface& seen, const Event& event) {
    Count& count = ledger_[Phase::scan_conversion];
    const Event last = pop_surface(pixel);
    pixel.element = sequences_.before(pixel.element);
    count(Operation::load_long);
    count(Operation::load);
    advance(pixel, event);
    classify(pixel, seen, event.primitive(), 1);
    if (pixel.is_set) return;
    advance(pixel, last);
    classify(pixel, seen, last.primitive(), 1);
  }

  /// Removes and returns the last surface of a pixel. Without counting, only its depth and primitive are exact.
  Event pop_surface(const PriorityPixel& pixel) {
    Event last{pixel.depth, 2 * sequences_.primitive(pixel.element)};
    if constexpr (Count::counts) {
      std::vector<Event>& drawn = drawn_[static_cast<std::size_t>(&pixel - pixels_.data())];
      last = drawn.back();
      drawn.pop_back();
    }
    return last;
  }

  const DisplaySubject& subject_;
  Ledger<Count>& ledger_;
  Displayed& result_;
  Sequences<Count> sequences_;
  std::vector<PriorityPixel> pixels_;
  std::vector<std::vector<Event>> drawn_;  ///< per pixel, for judge(); only with counting
  ScreenPieces screen_;
  std::vector<std::uint32_t> near_caps_;  ///< primitives that contain the start of some rays
};

template <class Count, bool has_depth_buffer>
Displayed list_priority(const DisplaySubject& subject) {
  const auto begin = std::chrono::steady_clock::now();
  Count preprocessing;
  const PolygonOptions options{directory_of(std::string(subject.directory)),
                               static_cast<std::uint32_t>(subject.bucket_size)};
  const Polygons polygons = clipped(subject.facets, subject.geometry, options, preprocessing);
  const double seconds = seconds_since(begin);
  Displayed result =
      display_facets<Count>(subject, [&](const ScreenFacets& seen, Ledger<Count>& ledger, Displayed& drawn) {
        ledger[Phase::preprocessing] = preprocessing;
        ListPriority<Count, has_depth_buffer> method(subject, ledger, drawn);
        method.draw(polygons, seen);
        if constexpr (Count::counts) method.judge();
      });
  result.preprocessing_seconds = seconds;
  return result;
}

}  // namespace

extern const DisplayRow list_priority_row{.name = "list-priority",
                                          .help = "draws polygons, clipped against each other, from front to back",
                                          .source = "Jansen 1987, 5.2, algorithm 5.2",
                                          .is_exact = false,
                                          .run = [](const DisplaySubject& subject, bool counts) {
                                            return counts ? list_priority<CountingMethod, false>(subject)
                                                          : list_priority<UncountedMethod, false>(subject);
                                          }};

extern const DisplayRow depth_buffer_row{
    .name = "list-priority/depth-buffer",
    .help = "list-priority with a buffer for the depth of the last polygon at each pixel",
    .source = "Jansen 1987, 5.2",
    .is_exact = false,
    .run = [](const DisplaySubject& subject, bool counts) {
      return counts ? list_priority<CountingMethod, true>(subject) : list_priority<UncountedMethod, true>(subject);
    }};

}  // namespace csgsim::software
