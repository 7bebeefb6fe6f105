// Classification by interval arithmetic.
// One of the rows of methods().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/box_planes.h"
#include "sim/software/methods/known.h"
#include "sim/software/methods/method.h"
#include "sim/software/methods/pruned.h"
#include "sim/software/traversals/early_out.h"
#include "sim/software/traversals/take_back.h"
#include "sim/software/tree/owners.h"

namespace csgsim::software {

/// Recursively halves boxes of pixels and depths from front to back and evaluates the solid in each by interval
/// arithmetic. Primitives that contain all or nothing of a box are pruned from the tree passed to its parts, and planes
/// that never bound their primitive in the box are dropped, so that rays get short trees. This is how fidget draws a
/// height map (Keeter 2020), with tapes of minima and maxima of all planes. No ray is cast before the boxes are small.
template <class Count>
class IntervalArithmetic : public Method {
 public:
  explicit IntervalArithmetic(const Subject& subject) : subject_(subject), owners_(subject.tree) {
    for (std::uint32_t primitive = 0; primitive < subject.geometry.solids.size(); ++primitive)
      planes_.push_back(planes_of(subject.model, subject.geometry, subject.view, primitive));
  }

  void classify(const RayBand& band, std::span<VisibleSurface> seen) override {
    band_ = {static_cast<std::int32_t>(band.width), static_cast<std::int32_t>(band.first_row), seen};
    std::ranges::fill(seen, VisibleSurface{subject_.farthest(), VisibleSurface::nothing_seen});
    const Tree tree = pruned(subject_.tree, classes_in_cell(subject_.view, band, 0, band.width), count_);
    for (std::uint32_t x = 0; x < band.width; x += band_rows) {
      const Box box{{static_cast<std::int32_t>(x), band_.first_row,
                     static_cast<std::int32_t>(std::min(x + band_rows, band.width)) - 1,
                     band_.first_row + static_cast<std::int32_t>(band.rows) - 1},
                    0,
                    subject_.farthest()};
      whole_.clear();
      known_ = classes_in_cell(subject_.view, band, x, band_rows);
      for (std::uint32_t primitive = 0; primitive < planes_.size(); ++primitive) {
        if (planes_[primitive].nowhere) known_[primitive] = Known::out;
        if (known_[primitive] != Known::out) whole_.push_back({primitive, planes_[primitive]});
      }
      if (!whole_.empty()) halve(box, whole_, tree);
    }
  }

  [[nodiscard]] Counts counts() const override {
    Counts counts = count_.counts_so_far();
    counts.words = max_words_;
    return counts;
  }

 private:
  /// Boxes with at most this number of pixels per side, or of open primitives, are drawn ray by ray.
  static constexpr std::int32_t min_side = 4;
  static constexpr std::size_t max_open = 2;

  using Open = std::vector<BoxPrimitive>;

  struct Band {
    std::int32_t width = 0;
    std::int32_t first_row = 0;
    std::span<VisibleSurface> seen;
  };

  VisibleSurface& seen_at(std::int32_t x, std::int32_t y) {
    return band_.seen[static_cast<std::size_t>(y - band_.first_row) * static_cast<std::size_t>(band_.width) +
                      static_cast<std::size_t>(x)];
  }

  bool is_set(const view::PixelRect& pixels) {
    for (std::int32_t y = pixels.y0; y <= pixels.y1; ++y) {
      for (std::int32_t x = pixels.x0; x <= pixels.x1; ++x) {
        if (seen_at(x, y).owner == VisibleSurface::nothing_seen) return false;
      }
    }
    return true;
  }

  /// `open`: primitives that contain part of the enclosing box; `tree`: the tree pruned for that box.
  void halve(const Box& box, const Open& open, const Tree& tree) {
    if (is_set(box.pixels)) return;
    Open left;
    for (const BoxPrimitive& one : open) {
      BoxPrimitive& narrowed = left.emplace_back(BoxPrimitive{one.primitive, {}});
      known_[one.primitive] = classify_in_box(subject_, box, one, narrowed, count_);
      if (known_[one.primitive] != Known::nothing) left.pop_back();
    }
    count_.evaluation();
    const Tree rest = pruned(tree, known_, count_);
    std::uint64_t words = words_of(rest);
    for (const BoxPrimitive& one : left) words += 1 + one.planes.fronts.size() + one.planes.backs.size();
    max_words_ = std::max(max_words_, words);
    if (rest.is_constant()) {
      // The solid fills the box, and no nearer surface was found, so the surface is the box's front.
      if (rest.complemented) set_all(box);
      return;
    }
    const bool is_small = box.pixels.x1 - box.pixels.x0 < min_side && box.pixels.y1 - box.pixels.y0 < min_side;
    if (is_small || left.size() <= max_open) return draw(box, left, rest);
    for (const bool is_far : {false, true}) {
      for (const Box& part : divide_half_box(box, is_far)) halve(part, left, rest);
    }
  }

  void set_all(const Box& box) {
    for (std::int32_t y = box.pixels.y0; y <= box.pixels.y1; ++y) {
      for (std::int32_t x = box.pixels.x0; x <= box.pixels.x1; ++x) set(x, y, box.z0);
    }
  }

  /// Finds the owner among all primitives of the picture at this pixel and sets the pixel.
  void set(std::int32_t x, std::int32_t y, std::uint32_t depth) {
    VisibleSurface& seen = seen_at(x, y);
    if (seen.owner != VisibleSurface::nothing_seen) return;
    intervals_along(whole_, x, y);
    active_.clear();
    for (const Interval& interval : intervals_) {
      if (interval.front <= depth && depth < interval.back) active_.push_back(interval.primitive);
    }
    seen = {depth, owners_.visible_owner(intervals_, depth, active_, count_)};
  }

  void intervals_along(const Open& open, std::int32_t x, std::int32_t y) {
    intervals_.clear();
    for (const BoxPrimitive& one : open) {
      const std::optional<Interval> interval = interval_at(subject_, one, x, y, count_);
      if (interval) intervals_.push_back(*interval);
    }
  }

  /// Draws ray by ray with the pruned tree.
  void draw(const Box& box, const Open& open, const Tree& tree) {
    EarlyOut<Count> traversal(tree);
    for (std::int32_t y = box.pixels.y0; y <= box.pixels.y1; ++y) {
      for (std::int32_t x = box.pixels.x0; x <= box.pixels.x1; ++x) {
        if (seen_at(x, y).owner != VisibleSurface::nothing_seen) continue;
        intervals_along(open, x, y);
        draw_ray(box, tree, traversal, x, y);
      }
    }
  }

  /// Collects the depths in the box at which a primitive begins or ends, including the box's front.
  void collect_depths(const Box& box) {
    depths_.assign(1, box.z0);
    for (const Interval& interval : intervals_) {
      for (const std::uint32_t depth : {interval.front, interval.back}) {
        if (depth > box.z0 && depth < box.z1) depths_.push_back(depth);
      }
    }
    std::ranges::sort(depths_);
    depths_.erase(std::unique(depths_.begin(), depths_.end()), depths_.end());
    count_(Operation::load_long, 2 * intervals_.size());
    count_(Operation::compare_long, 4 * intervals_.size() + depths_.size());
    count_(Operation::branch_taken, 2 * intervals_.size() + depths_.size());
    count_(Operation::store_long, depths_.size());
  }

  void draw_ray(const Box& box, const Tree& tree, EarlyOut<Count>& traversal, std::int32_t x, std::int32_t y) {
    collect_depths(box);
    for (const std::uint32_t depth : depths_) {
      active_.clear();
      for (const Interval& interval : intervals_) {
        const bool holds = interval.front <= depth && depth < interval.back;
        if (holds && tree.leaf_of[interval.primitive] != model::no_index) active_.push_back(interval.primitive);
      }
      flip_all(traversal, active_, count_);
      count_.point();
      count_.evaluation();
      count_(Operation::call);
      const bool is_in = traversal.evaluate(count_) != tree.complemented;
      undo_flips(traversal, active_, count_);
      if (!is_in) continue;
      // Intervals that start or end inside the box belong to its open primitives.
      const std::uint32_t owner =
          depth > box.z0 ? owners_.only_candidate(intervals_, depth, count_) : VisibleSurface::nothing_seen;
      if (owner == VisibleSurface::nothing_seen) return set(x, y, depth);
      seen_at(x, y) = {depth, owner};
      return;
    }
  }

  Subject subject_;
  Count count_;
  Owners<Count> owners_;
  std::vector<TilePlanes> planes_;  ///< one per primitive
  std::vector<Known> known_;        ///< one per primitive, for the current box
  Band band_;
  Open whole_;  ///< primitives in a column of the picture over the full depth
  std::vector<Interval> intervals_;
  std::vector<std::uint32_t> active_;
  std::vector<std::uint32_t> depths_;
  std::uint64_t max_words_ = 0;  ///< maximum over boxes
};

}  // namespace csgsim::software
