// Evaluation of trees, whole or pruned, by a traversal.
// Used by crossed.h and by sequences.h.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "sim/software/cost/operations.h"
#include "sim/software/methods/known.h"
#include "sim/software/methods/method.h"
#include "sim/software/methods/pruned.h"
#include "sim/software/traversals/levels.h"
#include "sim/software/traversals/take_back.h"

namespace csgsim::software {

/// A tree and its traversal. Each ray starts by undoing the flips of the previous one.
template <class Traversal, class Count>
class Evaluator {
 public:
  explicit Evaluator(Tree tree) : tree_(std::make_unique<Tree>(std::move(tree))) {
    if (tree_->is_constant()) return;
    refuse_deep(*tree_, Traversal::max_levels);
    traversal_.emplace(*tree_);
  }

  void start(Count& count) {
    if (traversal_) {
      count.traverse([&] {
        undo_flips(*traversal_, in_, count);
        return true;
      });
    }
    in_.clear();
  }

  /// Ignores a primitive that the tree does not contain.
  void flip(std::uint32_t primitive, Count& count) {
    count(Operation::load_long);
    count(Operation::branch);
    if (tree_->leaf_of[primitive] == model::no_index) return;
    const auto place = std::ranges::find(in_, primitive);
    const auto behind = static_cast<std::uint64_t>(in_.end() - place);
    count(Operation::load, in_.size() - behind);
    count(Operation::compare, in_.size() - behind);
    count(Operation::branch_taken, in_.size() - behind);
    count(Operation::store);
    if (place == in_.end()) {
      in_.push_back(primitive);
    } else {
      *place = in_.back();
      in_.pop_back();
    }
    count.traverse([&] {
      count(Operation::call);
      traversal_->flip(primitive, count);
      return true;
    });
  }

  bool evaluate(Count& count) {
    if (!traversal_) {
      count.look_up();
      return tree_->complemented;
    }
    count.evaluation();
    return count.traverse([&] {
      count(Operation::call);
      return traversal_->evaluate(count);
    }) != tree_->complemented;
  }

  [[nodiscard]] std::uint64_t words() const { return traversal_ ? traversal_->words() : 1; }

 private:
  std::unique_ptr<const Tree> tree_;
  std::optional<Traversal> traversal_;
  std::vector<std::uint32_t> in_;  ///< primitives that contain the point
};

/// Maximum number of primitives for Pruning::inside, where each has a separate tree over all primitives.
inline constexpr std::size_t max_inside = 4'096;

/// Number of primitives of a picture with Pruning::inside. Throws InputError if it exceeds max_inside.
inline std::size_t primitives_inside(const Subject& subject) {
  const std::size_t primitives = subject.model.primitives.size();
  if (primitives > max_inside) {
    throw InputError("the model has " + std::to_string(primitives) +
                     " primitives, but --reduced inside supports at most " + std::to_string(max_inside) +
                     "; use --reduced cells or none");
  }
  return primitives;
}

/// Evaluates the tree, whole or pruned, after the first events of a ray.
template <class Traversal, class Count>
class Evaluations {
 public:
  Evaluations(const Subject& subject, Count& count) : subject_(subject), count_(count) {
    if (subject.pruning == Pruning::none) trees_.emplace_back(std::in_place, subject.tree);
    if (subject.pruning == Pruning::inside) trees_.resize(primitives_inside(subject));
  }

  void begin_band(const RayBand& band) {
    width_ = band.width;
    if (subject_.pruning != Pruning::cells) return;
    trees_.clear();
    std::uint64_t words = 0;
    const Tree tree = pruned(subject_.tree, classes_in_cell(subject_.view, band, 0, band.width), count_);
    for (std::uint32_t first = 0; first < band.width; first += cell_columns) {
      const std::vector<Known> known = classes_in_cell(subject_.view, band, first, cell_columns);
      trees_.emplace_back(std::in_place, pruned(tree, known, count_));
      words += trees_.back()->words();
    }
    words_ = std::max(words_, words);
  }

  void begin_ray(std::size_t ray, std::span<const Event> events) {
    if (subject_.pruning == Pruning::cells) cell_ = ray % width_ / cell_columns;
    events_ = events;
    applied_ = 0;
    current_ = nullptr;
    entered_.clear();
  }

  /// Whether the solid contains the points after the first `events` events of the ray; the number never decreases
  /// within a ray.
  bool after(std::size_t events) {
    const std::span<const Event> added = events_.subspan(applied_, events - applied_);
    applied_ = events;
    if (subject_.pruning == Pruning::inside) return after_inside(added);
    Evaluator<Traversal, Count>& tree = *trees_[subject_.pruning == Pruning::cells ? cell_ : 0];
    if (current_ == nullptr) tree.start(count_);
    current_ = &tree;
    for (const Event& event : added) tree.flip(event.primitive(), count_);
    return tree.evaluate(count_);
  }

  [[nodiscard]] std::uint64_t words() const {
    if (subject_.pruning == Pruning::cells) return words_;
    std::uint64_t all = 0;
    for (const auto& tree : trees_) all += tree ? tree->words() : 0;
    return all;
  }

 private:
  using Slot = std::optional<Evaluator<Traversal, Count>>;

  /// Selects the tree of the primitive that was entered first among those that contain the point.
  bool after_inside(std::span<const Event> added) {
    for (const Event& event : added) {
      count_(Operation::load);
      count_(Operation::store);
      if (event.leaves()) {
        entered_.erase(std::ranges::find(entered_, event.primitive()));
      } else {
        entered_.push_back(event.primitive());
      }
    }
    if (entered_.empty()) {
      count_.look_up();
      return false;
    }
    Slot& slot = trees_[entered_.front()];
    if (!slot) slot.emplace(pruned(subject_.tree, classes_inside(subject_.view, entered_.front()), count_));
    if (current_ == &*slot) {
      for (const Event& event : added) slot->flip(event.primitive(), count_);
    } else {
      current_ = &*slot;
      slot->start(count_);
      for (const std::uint32_t primitive : entered_) slot->flip(primitive, count_);
    }
    return slot->evaluate(count_);
  }

  const Subject& subject_;
  Count& count_;
  std::vector<Slot> trees_;
  std::span<const Event> events_;
  std::size_t applied_ = 0;
  std::size_t cell_ = 0;
  std::uint32_t width_ = 1;
  const Evaluator<Traversal, Count>* current_ = nullptr;
  std::vector<std::uint32_t> entered_;  ///< primitives that contain the point, in the order of entry
  std::uint64_t words_ = 0;             ///< maximum over bands
};

}  // namespace csgsim::software
