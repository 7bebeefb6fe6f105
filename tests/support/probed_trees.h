#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"

namespace csgsim::test {

using array::LevelProbe;
using array::Place;
using array::PlaneShape;
using array::RootBits;
using array::Token;
using array::Words;

/// A wire with a delay of `length` clocks (0 to 63).
class DelayLine {
 public:
  explicit DelayLine(unsigned length) : length_(length) {}

  /// Output of the wire while `bit` is its input.
  [[nodiscard]] bool out(bool bit) const { return length_ == 0 ? bit : ((bits_ >> (length_ - 1)) & 1U) != 0; }
  void shift(bool bit) { bits_ = (bits_ << 1U) | (bit ? 1U : 0U); }

 private:
  unsigned length_;
  std::uint64_t bits_ = 0;
};

/// Tokens that travel with the stream through the levels of a tree. While the token's bit is below n-1-k, the
/// multiplicand wire still carries the previous instruction, and the multiplicand counts as 0.
class LevelTokens {
 public:
  explicit LevelTokens(unsigned levels) : tokens_(levels) {}

  [[nodiscard]] unsigned levels() const { return static_cast<unsigned>(tokens_.size()); }
  [[nodiscard]] bool any_active() const;

  /// Token at level k; `root` enters the tree in this clock.
  [[nodiscard]] Token at(unsigned level, Token root) const { return level == 0 ? root : tokens_[level - 1]; }

  /// Token that accompanies the streams at the leaves.
  [[nodiscard]] Token leaves(Token root) const { return at(levels(), root); }

  /// Whether the multiplicand wire is valid at level k.
  [[nodiscard]] bool multiplies(unsigned level, Token token) const {
    return token.bit >= static_cast<int>(levels() - 1 - level);
  }

  void shift(Token root);
  void clear();

 private:
  std::vector<Token> tokens_;
};

/// Independent judge of LinearEvaluator, which computes the tree's state from the coefficients: simulates the nodes on
/// the paths to some pixels, adder by adder and clock by clock. A plane has one bit per pixel, in the given order, in a
/// single row.
class ProbedTrees {
 public:
  /// `shape` is the shape of the array that contains the pixels.
  ProbedTrees(PlaneShape shape, std::span<const Place> pixels);

  [[nodiscard]] unsigned x_levels() const { return columns_.tokens.levels(); }
  [[nodiscard]] unsigned y_levels() const { return rows_.tokens.levels(); }
  [[nodiscard]] unsigned levels() const { return x_levels() + y_levels(); }
  [[nodiscard]] bool any_active() const { return columns_.tokens.any_active() || rows_.tokens.any_active(); }

  /// Same as LinearEvaluator::clock, but for the bits that reach the given pixels.
  bool clock(const RootBits& root, std::span<std::uint64_t> leaves);

  // Same as the functions of LinearEvaluator; x is the index of the pixel.
  [[nodiscard]] LevelProbe x_level(unsigned level, std::uint32_t x, const RootBits& root) const;
  [[nodiscard]] LevelProbe y_level(unsigned level, std::uint32_t x, const RootBits& root) const;

 private:
  /// State of a level on the path to each pixel, one bit per pixel.
  struct Level {
    Words goes_right;  ///< the path leads to the right child
    Words has_adder;   ///< the right child exists
    Words carry;
    Words out;  ///< the stream after this level
  };
  struct Tree {
    LevelTokens tokens;
    std::vector<Level> levels;

    Tree(std::uint32_t leaves, std::span<const std::uint32_t> ways);
    void clock(Token token, std::span<const std::uint64_t> in, bool multiplicand);
    [[nodiscard]] LevelProbe probe(unsigned level, std::uint32_t pixel, Token token, bool stream) const;
  };

  Tree columns_;
  Tree rows_;
  DelayLine a_;
  DelayLine b_;
  Words root_;  ///< the stream that enters the X tree
};

}  // namespace csgsim::test
