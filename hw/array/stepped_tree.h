#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

namespace csgsim::array {

/// Wires from the roots, on which a clock's bits can be tapped for so many clocks (0 to 64) after they entered.
class Wire {
 public:
  /// `entering`: the bits of this clock.
  [[nodiscard]] std::uint32_t at(unsigned delay, std::uint32_t entering) const {
    return delay == 0 ? entering : entered_[(newest_ + delay - 1) % entered_.size()];
  }
  void shift(std::uint32_t entering) {
    newest_ = (newest_ + entered_.size() - 1) % entered_.size();
    entered_[newest_] = entering;
  }

 private:
  std::array<std::uint32_t, 64> entered_{};  ///< a ring
  std::size_t newest_ = 0;
};

/// Wires as a tree sees them in a clock, which are so many clocks away from the roots.
struct Tap {
  const Wire& wire;
  std::uint32_t entering = 0;
  unsigned ahead = 0;

  [[nodiscard]] std::uint32_t at(unsigned delay) const { return wire.at(ahead + delay, entering); }
};

/// What the nodes of a tree share: of degree 1 the multiplicand; of degree 2 the factors of the square, and of the
/// product with the other coordinate.
struct TreeWires {
  Tap multiplicand;
  Tap square;
  Tap cross;
};

/// The bits of a clock, the first first: of each a plane, `node_words` words of a node after those of the node before,
/// a bit a lane.
using NodeBits = std::vector<Words>;

/// The streams that enter the nodes of a level. Of degree 1 there are values alone.
struct NodeStreams {
  NodeBits value;
  NodeBits slope;
  NodeBits row_slope;
};

/// A multiplier tree of LinearEvaluator node by node: the registers behind each, and its serial adders with their
/// carries. Many trees that share their wires are stepped side by side, a lane of the words each.
class SteppedTree {
 public:
  struct Form {
    unsigned degree = 1;
    unsigned bits = 1;      ///< that enter in a clock
    bool has_rows = false;  ///< an X tree of degree 2
  };

  SteppedTree(std::uint32_t leaves, std::size_t node_words, Form form);

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
    std::vector<NodeBits> delayed;  ///< a ring of the slopes that are on their way to the adders, a clock's each
    std::size_t oldest = 0;
    NodeStreams out;  ///< the children's registers
  };

  [[nodiscard]] std::uint32_t shifted(const Tap& tap, unsigned clocks, unsigned places, Token here) const;
  void add(Level& level, Token here, const NodeStreams& in, std::uint32_t multiplicand) const;
  void add_squares(unsigned k, Token here, const NodeStreams& in, const TreeWires& wires);
  void pass(const Level& level, Token here, const NodeBits& in, NodeBits& out) const;
  [[nodiscard]] const Words* delayed_slope(const Level& level, int bit, const NodeBits& slope) const;
  void delay_slope(Level& level, const NodeBits& slope) const;

  std::size_t node_words_;
  Form form_;
  std::vector<Token> tokens_;
  std::vector<Level> levels_;
};

}  // namespace csgsim::array
