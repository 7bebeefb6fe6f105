#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/plane.h"

namespace csgsim::array {

/// Which bit of an instruction's stream is on a wire.
struct Token {
  static constexpr std::int16_t idle = -1;
  std::int16_t bit = idle;

  [[nodiscard]] constexpr bool active() const { return bit != idle; }
  constexpr bool operator==(const Token&) const = default;
};

/// ceil(log2(leaves)), 0 for one leaf.
constexpr unsigned tree_levels(std::uint32_t leaves) {
  unsigned levels = 0;
  while ((std::uint64_t{1} << levels) < leaves) ++levels;
  return levels;
}

/// The tokens that travel with the stream through the levels of a multiplier tree. A tree of n levels multiplies by the
/// leaf's coordinate, one serial adder with carry and one delay a level.
///
/// A node of level k (root 0) covers 2^(n-k) leaves. It passes the incoming stream, one clock later, to its left child,
/// and the stream plus the multiplicand to its right child, whose leaves have coordinate bit n-1-k set. All levels
/// share the multiplicand wire. The stream reaches level k after k clocks and the multiplicand n-1 clocks after the
/// stream's first bit, so at level k it is worth 2^(n-1-k) times itself. While the token's bit is below n-1-k, the wire
/// still carries the instruction before, and the multiplicand counts as 0.
class LevelTokens {
 public:
  explicit LevelTokens(unsigned levels) : tokens_(levels) {}

  [[nodiscard]] unsigned levels() const { return static_cast<unsigned>(tokens_.size()); }
  [[nodiscard]] bool any_active() const;

  /// The token at level k, where `root` is the one that enters the tree in this clock.
  [[nodiscard]] Token at(unsigned level, Token root) const { return level == 0 ? root : tokens_[level - 1]; }

  /// The token that goes with the leaves' streams.
  [[nodiscard]] Token leaves(Token root) const { return at(levels(), root); }

  /// Whether the multiplicand wire counts at level k.
  [[nodiscard]] bool multiplies(unsigned level, Token token) const {
    return token.bit >= static_cast<int>(levels() - 1 - level);
  }

  void shift(Token root);
  void clear();

 private:
  std::vector<Token> tokens_;
};

/// Forms A*x + C for every column x of one row. Streams lie in words at the position of their node's first leaf.
class ColumnTree {
 public:
  explicit ColumnTree(std::uint32_t columns);

  [[nodiscard]] unsigned levels() const { return tokens_.levels(); }
  [[nodiscard]] bool any_active() const { return tokens_.any_active(); }
  [[nodiscard]] Token leaf_token(Token root) const { return tokens_.leaves(root); }

  /// Puts a bit on the wire that enters the tree.
  void set_root(bool bit) { streams_.front().front() = bit ? 1 : 0; }

  /// The columns' bits: the last level's registers, or the wire itself if there is no level.
  [[nodiscard]] std::span<const std::uint64_t> leaves() const { return streams_.back(); }

  void clock(Token token, bool multiplicand);
  void clear() { tokens_.clear(); }

 private:
  void clock_level(unsigned level, bool first, bool multiplicand);

  std::uint32_t columns_;
  LevelTokens tokens_;
  std::vector<Words> streams_;  ///< [k] enters level k; [levels] are the leaves
  std::vector<Words> carries_;
};

/// Adds B*y to the columns' streams for every row y of at least two. A stream is a row of words.
class RowTree {
 public:
  RowTree(std::uint32_t rows, std::size_t row_words);

  [[nodiscard]] unsigned levels() const { return tokens_.levels(); }
  [[nodiscard]] bool any_active() const { return tokens_.any_active(); }
  [[nodiscard]] Token leaf_token(Token root) const { return tokens_.leaves(root); }

  /// `columns`: the streams that enter the root. `leaves` are the last level's registers, rows * row_words words; they
  /// are written only in clocks in which a bit reaches them. Returns whether it did.
  bool clock(Token token, std::span<const std::uint64_t> columns, bool multiplicand, std::span<std::uint64_t> leaves);
  void clear() { tokens_.clear(); }

 private:
  [[nodiscard]] std::size_t nodes(unsigned level) const;

  std::uint32_t rows_;
  std::size_t row_words_;
  LevelTokens tokens_;
  std::vector<Words> streams_;  ///< [k] enters level k + 1
  std::vector<Words> carries_;
};

}  // namespace csgsim::array
