// Depth order of the polygons of a bucket.
// Used by list priority.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "host/view/projection.h"
#include "host/view/region.h"
#include "sim/software/cost/operations.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/rays/longs.h"

namespace csgsim::software {

/// Sorts the pieces of a bucket by depth, nearest first. The key is a piece's minimum depth over its pixel rectangle. A
/// piece that hides part of another precedes it, regardless of the keys: of one primitive, entering faces precede
/// leaving faces; of two primitives, the piece that is nearer where both have pixels precedes. Pieces at equal depth
/// keep the order of their keys. If pieces hide each other cyclically, the one with the smallest key comes first and is
/// a conflict.
template <class Count>
class DepthOrder {
 public:
  DepthOrder(const ScreenFacets& pieces, std::uint64_t longs, Count& count)
      : pieces_(pieces), longs_(longs), count_(count) {}

  /// Indices of the pieces from `begin` to `end`, sorted.
  const std::vector<std::uint32_t>& sorted_pieces(std::uint32_t begin, std::uint32_t end) {
    begin_ = begin;
    order_.clear();
    ranges_.clear();
    for (std::uint32_t i = begin; i < end; ++i)
      ranges_.push_back(view::range_over(pieces_.facets[i].depth, pieces_.facets[i].pixels));
    count_(Operation::multiply, 4 * longs_ * ranges_.size());
    count_(Operation::add_long, 4 * longs_ * ranges_.size());
    by_key_.resize(ranges_.size());
    std::iota(by_key_.begin(), by_key_.end(), std::size_t{0});
    std::ranges::stable_sort(by_key_, [&](std::size_t a, std::size_t b) {
      count_(Operation::load_long, 2);
      count_(Operation::compare_long);
      count_(Operation::branch_taken);
      count_(Operation::store_long);
      return ranges_[a].low < ranges_[b].low;
    });
    find_hidden();
    take_in_order();
    return order_;
  }

  [[nodiscard]] std::uint64_t conflicts() const { return conflicts_; }

 private:
  /// Drawing order of two pieces.
  enum class First : std::uint8_t { any, one, other };

  void find_hidden() {
    hides_.assign(ranges_.size(), {});
    hidden_by_.assign(ranges_.size(), 0);
    for (std::size_t i = 0; i < by_key_.size(); ++i) {
      for (std::size_t j = i + 1; j < by_key_.size(); ++j) {
        const First first = first_of(by_key_[i], by_key_[j]);
        if (first == First::one) add(by_key_[i], by_key_[j]);
        if (first == First::other) add(by_key_[j], by_key_[i]);
      }
    }
  }

  void add(std::size_t before, std::size_t behind) {
    hides_[before].push_back(behind);
    ++hidden_by_[behind];
    count_(Operation::store);
    count_(Operation::store_long);
    count_(Operation::add);
  }

  First first_of(std::size_t one, std::size_t other) {
    const ScreenFacet& a = pieces_.facets[begin_ + one];
    const ScreenFacet& b = pieces_.facets[begin_ + other];
    count_(Operation::load, 8);
    count_(Operation::compare, 5);
    count_(Operation::branch, 5);
    const view::PixelRect pixels = view::common(a.pixels, b.pixels);
    if (pixels.empty()) return First::any;
    if (a.primitive == b.primitive) {
      if (a.leaves == b.leaves) return First::any;
      return a.leaves ? First::other : First::one;
    }
    count_(Operation::load_long, 4);
    count_(Operation::compare_long, 2);
    count_(Operation::branch, 2);
    if (ranges_[one].high < ranges_[other].low) return First::one;
    if (ranges_[other].high < ranges_[one].low) return First::other;
    return nearer_of(a, b, pixels);
  }

  /// Compares depths at the corners of the region that both pieces cover.
  First nearer_of(const ScreenFacet& a, const ScreenFacet& b, const view::PixelRect& pixels) {
    view::Region common(pixels);
    for (const ScreenFacet* const piece : {&a, &b}) {
      for (const view::FixedLinear& bound : pieces_.bounds_of(*piece)) {
        count_values(common.corners().size());
        common.clip(bound);
        if (common.empty()) return First::any;
      }
    }
    count_values(common.corners().size());
    const auto [low, high] = common.range(view::difference(b.depth, a.depth));
    if (high == low && high == 0.0) return First::any;
    return high >= -low ? First::one : First::other;
  }

  /// Counts values of a linear function at corners, each of two products of `longs_` longs by a word.
  void count_values(std::size_t corners) {
    count_(Operation::load_long, 3 * longs_ + 2 * corners);
    count_(Operation::multiply, 2 * longs_ * corners);
    count_(Operation::add_long, 3 * longs_ * corners);
    count_(Operation::compare_long, corners);
    count_(Operation::branch, corners);
    count_(Operation::branch_taken, corners);
  }

  void take_in_order() {
    std::vector<std::size_t> left = by_key_;
    while (!left.empty()) {
      auto next = std::ranges::find_if(left, [&](std::size_t piece) { return hidden_by_[piece] == 0; });
      const std::size_t looked_at = std::min(left.size(), static_cast<std::size_t>(next - left.begin()) + 1);
      count_(Operation::load, looked_at);
      count_(Operation::branch, looked_at);
      if (next == left.end()) {
        next = left.begin();
        ++conflicts_;
      }
      const std::size_t piece = *next;
      left.erase(next);
      order_.push_back(begin_ + static_cast<std::uint32_t>(piece));
      count_(Operation::store_long, 2);
      // A drawn piece no longer blocks others; in a cycle, pieces are not blocked by it again.
      for (const std::size_t behind : hides_[piece]) --hidden_by_[behind];
      count_(Operation::load_long, hides_[piece].size());
      count_(Operation::add, hides_[piece].size());
    }
  }

  const ScreenFacets& pieces_;
  std::uint64_t longs_;
  Count& count_;
  std::uint32_t begin_ = 0;
  std::vector<view::Range> ranges_;  ///< depths with fraction bits of each piece over its rectangle
  std::vector<std::size_t> by_key_;
  std::vector<std::vector<std::size_t>> hides_;  ///< per piece, the pieces that must follow it
  std::vector<std::uint32_t> hidden_by_;         ///< per piece, the number of undrawn pieces that must precede it
  std::vector<std::uint32_t> order_;
  std::uint64_t conflicts_ = 0;
};

}  // namespace csgsim::software
