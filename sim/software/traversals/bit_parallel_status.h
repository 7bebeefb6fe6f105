// Bit-parallel traversal with stored status.
// One of the rows of methods().
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/developed_tree.h"

namespace csgsim::software {

/// Like bit-parallel, but the result of each word is stored. Only the word of a changed bit is recomputed, then the
/// words above it until one is unchanged. The thesis names the method in table 4.10 without describing it.
template <class Count>
class BitParallelStatus {
 public:
  static constexpr std::uint32_t max_levels = max_developed_levels;

  explicit BitParallelStatus(const Tree& tree)
      : tree_(tree),
        states_(std::size_t{1} << tree.depth(), Kept::in_memory),
        held_(tree_.words() * (1 + levels_above())) {
    Count none;
    for (std::size_t word = 0; word < tree_.words(); ++word) held_[word] = tree_.within_word(0, word, none) & 1U;
    for (std::uint32_t above = 1; above <= levels_above(); ++above) {
      for (std::size_t word = 0; word < tree_.words(); word += std::size_t{1} << above)
        held(above, word) = together(above, word, none);
    }
  }

  void flip(std::uint32_t primitive, Count& count) {
    const std::uint32_t place = tree_.place_of(primitive);
    count(Operation::load);
    count(Operation::come_back);
    states_.flip(place, count);
    std::size_t word = place / word_bits;
    count(Operation::load_long);
    if (!is_changed(held_[word], tree_.within_word(states_.as_words()[word], word, count) & 1U, count)) return;
    for (std::uint32_t above = 1; above <= levels_above(); ++above) {
      word &= ~((std::size_t{1} << above) - 1);
      if (!is_changed(held(above, word), together(above, word, count), count)) return;
    }
  }

  bool evaluate(Count& count) const {
    count(Operation::load);
    count(Operation::come_back);
    return held_[levels_above() * tree_.words()] != 0;
  }

  /// The number of stored words halves from level to level.
  [[nodiscard]] std::uint64_t words() const {
    return tree_.words_of_memory() + states_.word_count() + 2 * std::uint64_t{tree_.words()};
  }

 private:
  [[nodiscard]] std::uint32_t levels_above() const {
    return tree_.levels() > levels_in_word ? tree_.levels() - levels_in_word : 0;
  }

  /// Result of the words starting at `word`, at a level above those within a word.
  std::uint32_t& held(std::uint32_t above, std::size_t word) { return held_[above * tree_.words() + word]; }

  std::uint32_t together(std::uint32_t above, std::size_t word, Count& count) {
    const std::uint32_t level = levels_in_word + above;
    const std::size_t other = word + DevelopedTree::distance(level);
    return tree_.above_words(level, word, held(above - 1, word), held(above - 1, other), count) & 1U;
  }

  static bool is_changed(std::uint32_t& before, std::uint32_t now, Count& count) {
    count(Operation::logic_long);
    count(Operation::load);
    count(Operation::compare);
    if (before == now) {
      count(Operation::branch_taken);
      count.early_out();
      return false;
    }
    count(Operation::branch);
    count(Operation::store);
    before = now;
    return true;
  }

  DevelopedTree tree_;
  BitString<Count> states_;
  std::vector<std::uint32_t> held_;
};

}  // namespace csgsim::software
