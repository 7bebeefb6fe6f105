#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

namespace csgsim::array {

/// A wire from the roots, on which a bit can be tapped for so many clocks (0 to 64) after it entered.
class Wire {
 public:
  /// `entering`: the bit of this clock.
  [[nodiscard]] bool at(unsigned delay, bool entering) const {
    return delay == 0 ? entering : (bits_ >> (delay - 1) & 1U) != 0;
  }
  void shift(bool entering) { bits_ = bits_ << 1U | (entering ? 1U : 0U); }

 private:
  std::uint64_t bits_ = 0;
};

/// A wire as a tree sees it in a clock, which is so many clocks away from the roots.
struct Tap {
  const Wire& wire;
  bool entering = false;
  unsigned ahead = 0;

  [[nodiscard]] bool at(unsigned delay) const { return wire.at(ahead + delay, entering); }
};

/// What the nodes of a tree share: of degree 1 the multiplicand; of degree 2 the factors of the square, and of the
/// product with the other coordinate.
struct TreeWires {
  Tap multiplicand;
  Tap square;
  Tap cross;
};

/// The streams that enter the nodes of a level, `node_words` words each after those of the node before: a bit a lane.
/// Of degree 1 there are values alone.
struct NodeStreams {
  Words value;
  Words slope;
  Words row_slope;
};

/// A multiplier tree of LinearEvaluator node by node: the registers behind each, and its serial adders with their
/// carries. Many trees that share their wires are stepped side by side, a lane of the words each.
class SteppedTree {
 public:
  /// `has_rows`: of an X tree of degree 2.
  SteppedTree(std::uint32_t leaves, std::size_t node_words, unsigned degree, bool has_rows);

  [[nodiscard]] unsigned levels() const { return static_cast<unsigned>(levels_.size()); }
  [[nodiscard]] bool any_active() const;

  /// The token at a level in a clock in which `root` enters; that of the leaves is at the last.
  [[nodiscard]] Token token_at(unsigned level, Token root) const { return level == 0 ? root : tokens_[level - 1]; }

  /// What enters the nodes of a level, `root` the first.
  [[nodiscard]] const NodeStreams& at(unsigned level, const NodeStreams& root) const {
    return level == 0 ? root : levels_[level - 1].out;
  }

  /// One clock, in which that token and those bits are at the root.
  void clock(Token token, const NodeStreams& root, const TreeWires& wires);

  /// What is at the node of a level on the way to that leaf, in a lane.
  [[nodiscard]] LevelProbe probe(unsigned level, std::uint32_t leaf, std::size_t lane, Token token,
                                 const NodeStreams& root) const;

 private:
  struct Level {
    unsigned below = 0;  ///< levels under its children
    std::size_t nodes = 0;
    std::size_t pairs = 0;  ///< the nodes, from the first on, that have a right child
    Words value_carry;
    Words step_carry;
    Words slope_carry;
    Words row_carry;
    std::vector<Words> delayed;  ///< a ring of the slopes that are on their way to the adders, `below` clocks
    std::size_t oldest = 0;
    NodeStreams out;  ///< the children's registers
  };

  void add(Level& level, Token here, const NodeStreams& in, bool multiplicand) const;
  void add_squares(unsigned k, Token here, const NodeStreams& in, const TreeWires& wires);
  void pass(const Level& level, const Words& in, Words& out) const;
  [[nodiscard]] const Words& delayed_slope(Level& level, const Words& slope) const;

  std::size_t node_words_;
  unsigned degree_;
  bool has_rows_;
  std::vector<Token> tokens_;
  std::vector<Level> levels_;
  Words delayed_;  ///< for one level
};

}  // namespace csgsim::array
