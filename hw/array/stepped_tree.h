// Multiplier tree with registers and serial adders.
// Used by SteppedEvaluator.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

namespace csgsim::array {

/// A group of wires from the roots. Bits can be tapped up to 64 clocks after they entered.
class Wire {
 public:
  /// The bits that entered `delay_clocks` clocks ago. `entering`: the bits that enter in this clock, for delay 0.
  [[nodiscard]] std::uint32_t at(unsigned delay_clocks, std::uint32_t entering) const {
    return delay_clocks == 0 ? entering : entered_[(newest_ + delay_clocks - 1) % entered_.size()];
  }
  void shift(std::uint32_t entering) {
    newest_ = (newest_ + entered_.size() - 1) % entered_.size();
    entered_[newest_] = entering;
  }

 private:
  std::array<std::uint32_t, 64> entered_{};  ///< a ring
  std::size_t newest_ = 0;
};

/// Wires as seen by a tree whose root is `ahead` clocks away from the roots of the wires.
struct Tap {
  const Wire& wire;
  std::uint32_t entering = 0;
  unsigned ahead = 0;

  [[nodiscard]] std::uint32_t at(unsigned delay_clocks) const { return wire.at(ahead + delay_clocks, entering); }
};

/// Operands shared by all nodes of a tree: the multiplicand in degree 1; the factors of the square and of the product
/// with the other coordinate in degree 2.
struct TreeWires {
  Tap multiplicand;
  Tap square;
  Tap cross;
};

/// The stream bits of one clock, one plane per bit, the first bit first. A plane has `node_words` words per node, one
/// bit per lane.
using NodeBits = std::vector<Words>;

/// The streams that enter the nodes of a level. Degree 1 uses only the value.
struct NodeStreams {
  NodeBits value;
  NodeBits slope;
  NodeBits row_slope;
};

/// A multiplier tree of LinearEvaluator node by node, with registers, serial adders and carries. Trees that share their
/// wires are simulated side by side, one lane of the words each.
class SteppedTree {
 public:
  /// `has_rows`: true for an X tree of degree 2, which computes row slopes.
  SteppedTree(std::uint32_t leaves, std::size_t node_words, TreeForm form, bool has_rows);

  [[nodiscard]] unsigned levels() const { return depth_.levels; }
  [[nodiscard]] unsigned clocks() const { return depth_.clocks(); }
  [[nodiscard]] bool any_active() const;

  /// The token at a level in a clock in which `root` enters. The leaves are the last level.
  [[nodiscard]] Token token_at(unsigned level, Token root) const {
    const unsigned clocks = depth_.clocks_to(level);
    return clocks == 0 ? root : tokens_[clocks - 1];
  }

  /// The streams that enter the nodes of a level; those of level 0 are `root`. For a level without registers before it,
  /// these are the streams of the last clock.
  [[nodiscard]] const NodeStreams& at(unsigned level, const NodeStreams& root) const {
    return level == 0 ? root : levels_[level - 1].out;
  }

  /// Advances one clock, in which `token` and the streams `root` enter at the root.
  void clock(Token token, const NodeStreams& root, const TreeWires& wires);

  /// Signals at the node of a level on the path to a leaf, in one lane, in a clock in which `token` and the streams
  /// `root` enter at the root.
  [[nodiscard]] LevelProbe probe(unsigned level, std::uint32_t leaf, std::size_t lane, Token token,
                                 const NodeStreams& root, const TreeWires& wires) const;

 private:
  struct Level {
    unsigned below = 0;  ///< levels below its children
    std::size_t nodes = 0;
    std::size_t pairs = 0;  ///< number of nodes with a right child; these come first
    Words value_carry;
    Words step_carry;
    Words slope_carry;
    Words row_carry;
    std::vector<NodeBits> delayed;  ///< ring of slopes on their way to the adders, one entry per clock
    std::size_t oldest = 0;
    NodeStreams out;  ///< the children's registers
  };

  /// The bits of a node's streams in one lane and clock.
  struct LaneBits {
    std::uint32_t value = 0;
    std::uint32_t slope = 0;
    std::uint32_t row_slope = 0;
  };

  [[nodiscard]] LaneBits lane_bits(const NodeStreams& in, Token token, std::size_t node, std::size_t lane) const;
  [[nodiscard]] LaneBits right_child(unsigned level_number, std::size_t node, std::size_t lane, Token token,
                                     LaneBits in, const TreeWires& wires) const;
  [[nodiscard]] std::uint32_t delayed_slope_bits(const Level& level, std::size_t node, std::size_t lane, Token token,
                                                 std::uint32_t slope) const;
  [[nodiscard]] std::uint32_t weighted_bits(const Tap& tap, unsigned clocks, unsigned weight_log2, Token token) const;
  void clock_linear_level(Level& level, Token token, const NodeStreams& in, std::uint32_t multiplicand) const;
  void clock_level(unsigned level_number, Token token, const NodeStreams& in, const TreeWires& wires);
  void clock_quadratic_level(unsigned level_number, Token token, const NodeStreams& in, const TreeWires& wires);
  void pass_to_left_children(const Level& level, Token token, const NodeBits& in, NodeBits& out) const;
  /// Position of a delayed slope bit: clocks since the bit entered the ring, and index among the bits of that clock.
  struct Delayed {
    std::size_t clocks = 0;
    std::size_t plane = 0;
  };
  [[nodiscard]] std::optional<Delayed> delayed_bit(const Level& level, int stream_bit) const;
  static const NodeBits& slopes_entered(const Level& level, std::size_t clocks_ago);
  [[nodiscard]] const Words* delayed_slope(const Level& level, int stream_bit, const NodeBits& slope) const;
  void delay_slope(Level& level, const NodeBits& slope) const;

  std::size_t node_words_;
  TreeForm form_;
  bool has_rows_;
  TreeDepth depth_;
  std::vector<Token> tokens_;  ///< tokens at the registers
  std::vector<Level> levels_;
};

}  // namespace csgsim::array
