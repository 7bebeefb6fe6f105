// Classification by the boolean weave of BRL-CAD.
// One of the rows of methods().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/method.h"
#include "sim/software/traversals/early_out.h"
#include "sim/software/traversals/take_back.h"
#include "sim/software/tree/owners.h"

namespace csgsim::software {

/// The boolean weave of BRL-CAD's ray tracer (src/librt/bool.c). The ray's unsorted intervals are inserted one by one
/// into a list of partitions, each a section of the ray with the primitives that contain it. The tree is then evaluated
/// with early outs for one partition after another from the front until one is inside. Events need not be sorted.
template <class Count>
class Weave : public Method {
 public:
  explicit Weave(const Subject& subject) : subject_(subject), owners_(subject.tree) {
    if (!subject.tree.is_constant()) traversal_.emplace(subject.tree);
  }

  void classify(const RayBand& band, std::span<VisibleSurface> seen) override {
    for (std::size_t ray = 0; ray < seen.size(); ++ray) seen[ray] = seen_along(band.intervals_of(ray));
  }

  [[nodiscard]] Counts counts() const override {
    Counts counts = count_.counts_so_far();
    counts.words = max_words_ + (traversal_ ? traversal_->words() : 0);
    return counts;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// A section of the ray, begin <= z < end.
  struct Partition {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t next = none;
    std::vector<std::uint32_t> held_by;  ///< primitives that contain the section
  };

  VisibleSurface seen_along(std::span<const Interval> intervals) {
    used_ = 0;
    first_ = none;
    for (const Interval& interval : intervals) weave(interval);
    std::uint64_t words = 0;
    for (std::size_t i = 0; i < used_; ++i) words += 4 + pool_[i].held_by.size() / 2;
    max_words_ = std::max(max_words_, words);
    for (std::uint32_t at = first_; at != none; at = pool_[at].next) {
      count_.point();
      count_(Operation::load_long);
      if (holds(pool_[at].held_by))
        return {pool_[at].begin, owners_.visible_owner(intervals, pool_[at].begin, pool_[at].held_by, count_)};
    }
    return {subject_.farthest(), VisibleSurface::nothing_seen};
  }

  bool holds(std::span<const std::uint32_t> held_by) {
    flip_all(*traversal_, held_by, count_);
    count_.evaluation();
    count_(Operation::call);
    const bool is_in = traversal_->evaluate(count_);
    undo_flips(*traversal_, held_by, count_);
    return is_in;
  }

  std::uint32_t add_partition(std::uint32_t begin, std::uint32_t end, std::uint32_t next) {
    if (used_ == pool_.size()) pool_.emplace_back();
    Partition& partition = pool_[used_];
    partition.begin = begin;
    partition.end = end;
    partition.next = next;
    partition.held_by.clear();
    count_.list_element();
    count_(Operation::store_long, 4);
    count_(Operation::load_long, 2);
    return static_cast<std::uint32_t>(used_++);
  }

  /// Inserts a partition into the list after `before`, or at its start if that is none.
  void link(std::uint32_t before, std::uint32_t partition) {
    count_(Operation::store_long);
    (before == none ? first_ : pool_[before].next) = partition;
  }

  void add(std::uint32_t partition, std::uint32_t primitive) {
    count_(Operation::store);
    count_(Operation::add_long);
    pool_[partition].held_by.push_back(primitive);
  }

  /// Splits a partition at a depth; the new rear part has the same primitives.
  void split(std::uint32_t at, std::uint32_t depth) {
    const std::uint32_t behind = add_partition(depth, pool_[at].end, pool_[at].next);
    pool_[behind].held_by = pool_[at].held_by;
    count_(Operation::load, pool_[at].held_by.size());
    count_(Operation::store, pool_[at].held_by.size());
    count_(Operation::branch_taken, pool_[at].held_by.size());
    pool_[at].end = depth;
    pool_[at].next = behind;
    count_(Operation::store_long, 2);
  }

  void count_step() {
    count_.list_step();
    count_(Operation::load_long, 2);
    count_(Operation::compare_long, 2);
    count_(Operation::branch, 2);
    count_(Operation::branch_taken);
  }

  void weave(const Interval& interval) {
    std::uint32_t begin = interval.front;
    std::uint32_t before = none;
    std::uint32_t at = first_;
    while (begin < interval.back) {
      count_step();
      if (at != none && pool_[at].end <= begin) {  // the partition ends before the interval
        before = at;
        at = pool_[at].next;
        continue;
      }
      if (at == none || pool_[at].begin > begin) {  // no primitive contains the ray here yet
        const std::uint32_t end = at == none ? interval.back : std::min(interval.back, pool_[at].begin);
        const std::uint32_t fresh = add_partition(begin, end, at);
        link(before, fresh);
        add(fresh, interval.primitive);
        before = fresh;
        begin = end;
        continue;
      }
      if (pool_[at].begin < begin) {
        split(at, begin);
      } else {
        if (pool_[at].end > interval.back) split(at, interval.back);
        add(at, interval.primitive);
        begin = pool_[at].end;
      }
      before = at;
      at = pool_[at].next;
    }
  }

  Subject subject_;
  Count count_;
  std::optional<EarlyOut<Count>> traversal_;
  Owners<Count> owners_;
  std::vector<Partition> pool_;
  std::size_t used_ = 0;
  std::uint32_t first_ = none;
  std::uint64_t max_words_ = 0;
};

}  // namespace csgsim::software
