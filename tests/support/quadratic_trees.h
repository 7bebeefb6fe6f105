#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"
#include "tests/support/probed_trees.h"

namespace csgsim::test {

/// A wire from the root with taps at delays of 0 to 64 clocks.
class TappedWire {
 public:
  /// `bit` enters in this clock.
  [[nodiscard]] bool at(unsigned delay, bool bit) const {
    return delay == 0 ? bit : ((bits_ >> (delay - 1)) & 1U) != 0;
  }
  void shift(bool bit) { bits_ = (bits_ << 1U) | (bit ? 1U : 0U); }

 private:
  std::uint64_t bits_ = 0;
};

/// Adds two streams, least significant bit first.
struct SerialAdder {
  bool carry = false;

  bool add(bool one, bool other) {
    const bool sum = (one != other) != carry;
    carry = (one && other) || (carry && (one || other));
    return sum;
  }
};

/// Streams at a node: the value at its first leaf, the slope there, and in the X tree the slope along the column.
struct NodeStreams {
  bool value = false;
  bool slope = false;
  bool row_slope = false;
};

/// Independent judge of LinearEvaluator for trees of degree 2: simulates the nodes on the path to a pixel, adder by
/// adder and clock by clock. Each level has separate delays and adders; only the coefficients of the squares arrive on
/// wires that levels share.
class QuadraticWay {
 public:
  QuadraticWay(PlaneShape shape, Place pixel);

  void clock(const RootBits& root);

  // Same as the functions of LinearEvaluator, for this pixel.
  [[nodiscard]] LevelProbe x_level(unsigned level, const RootBits& root) const;
  [[nodiscard]] LevelProbe y_level(unsigned level, const RootBits& root) const;

 private:
  struct Level {
    unsigned below;   ///< levels below its children
    bool goes_right;  ///< the path leads to the right child
    bool has_adders;  ///< the right child exists
    DelayLine delayed_slope;
    SerialAdder value{};
    SerialAdder step{};
    SerialAdder slope{};
    SerialAdder row_slope{};
    NodeStreams out{};  ///< streams after this level
  };
  /// Bits on the shared wires in a clock.
  struct Wires {
    const TappedWire& square;
    const TappedWire& cross;
    bool square_in;
    bool cross_in;
    unsigned ahead;  ///< clocks by which the wires' bits enter before the tree's streams
  };
  struct Tree {
    LevelTokens tokens;
    std::vector<Level> levels;

    Tree(std::uint32_t leaves, std::uint32_t leaf);
    void clock(Token token, NodeStreams in, const Wires& wires);
    void clock_level(unsigned level_index, Token token, NodeStreams in, const Wires& wires);
    [[nodiscard]] NodeStreams at(unsigned level, NodeStreams in) const {
      return level == 0 ? in : levels[level - 1].out;
    }
    [[nodiscard]] LevelProbe probe(unsigned level, Token token, NodeStreams in) const;
  };

  [[nodiscard]] NodeStreams row_streams(const RootBits& root) const;

  Tree columns_;
  Tree rows_;
  TappedWire xx_;
  TappedWire xy_;
  TappedWire yy_;
};

}  // namespace csgsim::test
