// Complete binary trees for bit-parallel evaluation.
// Used by the bit-parallel traversals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/bit_string.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Number of tree levels that are evaluated within a word.
inline constexpr std::uint32_t levels_in_word = 5;

/// Maximum depth of a developed tree: 2^20 bits are 32,768 words to process per point.
inline constexpr std::uint32_t max_developed_levels = 20;

/// A complete binary tree with 2^n places for n levels. A leaf is at the leftmost place of its subtree; bit 0 is the
/// leftmost. Every operator becomes an AND by inverting bits before and after it (thesis 4.4.2, table 4.7): both
/// operands of a union, and of a place without operator; the right operand of a difference; none of an intersection.
class DevelopedTree {
 public:
  explicit DevelopedTree(const Tree& tree)
      : levels_(tree.depth()),
        words_(tree.depth() > levels_in_word ? std::size_t{1} << (levels_ - levels_in_word) : 1) {
    place_of_.assign(tree.leaf_of.size(), model::no_index);
    // A place without operator is a union with an empty right operand.
    patterns_.assign(levels_ * words_, ~std::uint32_t{0});
    struct Entry {
      std::uint32_t node;
      std::uint32_t place;
      std::uint32_t level;
    };
    std::vector<Entry> open{{tree.root, 0, levels_}};
    while (!open.empty()) {
      const Entry entry = open.back();
      open.pop_back();
      const Node& node = tree.nodes[entry.node];
      if (node.is_leaf) {
        place_of_[node.primitive] = entry.place;
        continue;
      }
      const std::uint32_t right = entry.place + (1U << (entry.level - 1));
      set(entry.level, entry.place, node.op == model::Operator::unite);
      set(entry.level, right, node.op != model::Operator::intersect);
      open.push_back({node.left, entry.place, entry.level - 1});
      open.push_back({node.right, right, entry.level - 1});
    }
  }

  [[nodiscard]] std::uint32_t levels() const { return levels_; }
  [[nodiscard]] std::size_t words() const { return words_; }
  [[nodiscard]] std::uint32_t place_of(std::uint32_t primitive) const { return place_of_[primitive]; }
  /// Bits of a word that are inverted at a level; the leaves are level 1.
  [[nodiscard]] std::uint32_t pattern(std::uint32_t level, std::size_t word) const {
    return patterns_[(level - 1) * words_ + word];
  }
  /// Words of patterns and places. Above the levels within a word, only every second, fourth, ... pattern is stored.
  [[nodiscard]] std::uint64_t words_of_memory() const {
    std::uint64_t all = place_of_.size() / 2;
    for (std::uint32_t level = 1; level <= levels_; ++level)
      all += level <= levels_in_word ? words_ : words_ >> (level - levels_in_word - 1);
    return all;
  }

  /// Evaluates the levels within a word; bit 0 is the result. Each level takes three operations and a shift.
  template <class Count>
  std::uint32_t within_word(std::uint32_t bits, std::size_t word, Count& count) const {
    const std::uint32_t levels = levels_ < levels_in_word ? levels_ : levels_in_word;
    count.visit();
    for (std::uint32_t level = 1; level <= levels; ++level) {
      const std::uint32_t p = pattern(level, word);
      const std::uint32_t places = 1U << (level - 1);
      count(Operation::load_long);
      count(Operation::logic_long, 3);
      count(Operation::move);
      count.shift(places);
      count(Operation::branch_taken);
      bits ^= p;
      bits &= bits >> places;
      bits ^= p;
    }
    return bits;
  }

  /// Combines the results of two words into bit 0; `word` is the left one, `level` is above those within a word.
  template <class Count>
  std::uint32_t above_words(std::uint32_t level, std::size_t word, std::uint32_t left, std::uint32_t right,
                            Count& count) const {
    const std::size_t other = word + distance(level);
    count.visit();
    count(Operation::load_long, 4);
    count(Operation::logic_long, 4);
    count(Operation::add_long);
    count(Operation::branch_taken);
    const std::uint32_t inverted = pattern(level, word);
    return ((left ^ inverted) & (right ^ pattern(level, other))) ^ inverted;
  }

  /// Distance of the two words that a level combines.
  static constexpr std::size_t distance(std::uint32_t level) { return std::size_t{1} << (level - levels_in_word - 1); }

 private:
  void set(std::uint32_t level, std::uint32_t place, bool is_inverted) {
    std::uint32_t& word = patterns_[(level - 1) * words_ + place / word_bits];
    const std::uint32_t bit = std::uint32_t{1} << (place % word_bits);
    word = is_inverted ? word | bit : word & ~bit;
  }

  std::uint32_t levels_;
  std::size_t words_;
  std::vector<std::uint32_t> place_of_;
  std::vector<std::uint32_t> patterns_;  ///< one word each, level by level
};

}  // namespace csgsim::software
