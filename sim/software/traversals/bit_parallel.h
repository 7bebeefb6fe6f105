// Bit-parallel traversal.
// One of the rows of methods().
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/developed_tree.h"

namespace csgsim::software {

/// Evaluates all nodes of a level at once by three operations on the string of states (thesis 4.4.2, figure 4.13). A
/// string longer than a word is evaluated word by word, and the results are combined at the upper levels.
template <class Count>
class BitParallel {
 public:
  static constexpr std::uint32_t max_levels = max_developed_levels;

  explicit BitParallel(const Tree& tree)
      : tree_(tree), states_(std::size_t{1} << tree.depth(), Kept::in_memory), work_(tree_.words()) {}

  void flip(std::uint32_t primitive, Count& count) {
    count(Operation::load);
    count(Operation::come_back);
    states_.flip(tree_.place_of(primitive), count);
  }

  bool evaluate(Count& count) {
    const std::span<const std::uint32_t> states = states_.as_words();
    for (std::size_t word = 0; word < work_.size(); ++word) {
      count(Operation::load_long);
      work_[word] = tree_.within_word(states[word], word, count);
      if (work_.size() > 1) count(Operation::store_long);
    }
    for (std::uint32_t level = levels_in_word + 1; level <= tree_.levels(); ++level) {
      const std::size_t apart = DevelopedTree::distance(level);
      for (std::size_t word = 0; word < work_.size(); word += 2 * apart) {
        work_[word] = tree_.above_words(level, word, work_[word], work_[word + apart], count);
        count(Operation::store_long);
      }
    }
    count(Operation::logic_long);
    count(Operation::come_back);
    return (work_[0] & 1U) != 0;
  }

  [[nodiscard]] std::uint64_t words() const { return tree_.words_of_memory() + states_.word_count() + work_.size(); }

 private:
  DevelopedTree tree_;
  BitString<Count> states_;
  std::vector<std::uint32_t> work_;
};

}  // namespace csgsim::software
