// Model of the linear expression evaluator, computed from coefficients.
// Used by hw/array and hw/pixel_planes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

namespace csgsim::array {

/// Coefficient bits that the controller sends in one clock, selected by the token, lowest bit first. Trees of degree 1
/// have no wires for xx, xy and yy.
struct RootBits {
  Token token;
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t c = 0;
  std::uint32_t xx = 0;
  std::uint32_t xy = 0;
  std::uint32_t yy = 0;

  constexpr bool operator==(const RootBits&) const = default;
};

/// Levels of a tree with that number of leaves: ceil(log2(leaves)), 0 for one leaf.
constexpr unsigned tree_levels(std::uint32_t leaves) {
  unsigned levels = 0;
  while ((std::uint64_t{1} << levels) < leaves) ++levels;
  return levels;
}

/// Parameters of the trees.
struct TreeForm {
  unsigned degree = 1;           ///< degree of the expressions, 1 or 2
  unsigned bits = 1;             ///< bits of a stream carried in parallel
  unsigned register_levels = 1;  ///< levels from one register to the next
};

/// Depth of a tree. There are registers after every `between_registers` levels and after the last level.
struct TreeDepth {
  unsigned levels = 0;
  unsigned between_registers = 1;

  /// Clocks from the root to a level; the leaves are level `levels`.
  [[nodiscard]] constexpr unsigned clocks_to(unsigned level) const {
    return level == levels ? clocks() : level / between_registers;
  }
  [[nodiscard]] constexpr unsigned clocks() const { return (levels + between_registers - 1) / between_registers; }
};

/// Signals at a tree level on the path to a pixel, in the middle of a clock.
struct LevelProbe {
  Token token;               ///< stream bits that enter the level
  std::uint32_t stream = 0;  ///< values of those bits
  bool carry = false;        ///< carry into the level's adder for the first bit; false if the node has no right child

  // The following members are used only in trees of degree 2. The slope is the growth of the value from leaf to leaf
  // without the square term.
  std::uint32_t slope = 0;
  bool slope_carry = false;
  bool step_carry = false;       ///< carry of the adder that adds the square term to the slope
  std::uint32_t row_slope = 0;   ///< in the X tree: the slope along the column, which enters the Y tree
  bool row_slope_carry = false;  ///< in the X tree
};

/// The Linear Expression Evaluator (thesis 7.2.1): an X tree over the columns, each of whose leaves sends A*x + C into
/// a Y tree over the rows. Bit j of A*x + B*y + C reaches the pixels latency() clocks after bit j of A, B and C
/// entered, for back-to-back instructions of any width. w bits (1 to 32) enter in a clock; the last clock of a stream
/// may have fewer.
///
/// A tree of n levels multiplies by the leaf's coordinate with one serial adder and one delay per level. A node of
/// level k (root 0) covers 2^(n-k) leaves. It passes the incoming stream, one clock later, to its left child, and the
/// stream plus the multiplicand to its right child, whose leaves have coordinate bit n-1-k set. All levels share the
/// multiplicand wire. The stream reaches level k after k clocks, and the multiplicand n-1 clocks after the stream's
/// first bit, so at level k the multiplicand has weight 2^(n-1-k); before its first bit it counts as 0.
///
/// If w bits enter per clock, each adder is w bits wide and stores the carry out of its top bit. A factor of two
/// is then one bit instead of one clock, so each level needs its own tap. For weight 2^s, s = n-1-k, bit j - s of the
/// multiplicand has to meet bit j of the stream at level k. The wires are tapped twice, floor(s / w) clocks after they
/// passed with the stream's bits and one clock later; w of these 2w bits are added, beginning s mod w below the first
/// bit of the later clock. So the wires to a level are shifted by s mod w places, once for all its nodes. Bits before
/// the multiplicand's first count as 0. With w = 1 there is no shift, and one tap serves all levels.
///
/// Trees of degree 2 compute xx*x*x + xy*x*y + yy*y*y + a*x + b*y + c. A node of the X tree whose first leaf is X has
/// three aligned streams: the value xx*X*X + a*X + c, the slope 2*xx*X + a and the row slope xy*X + b. For its right
/// child, h = 2^(n-1-k) leaves further on, it adds h*(slope + h*xx), 2*h*xx and h*xy to them with four serial adders;
/// the two of the value are chained within a clock. The node delays the slope by n-1-k clocks, which gives it weight h;
/// xx and xy come on wires shared by all nodes of a level, delayed for the weights h*h, 2*h and h. A node of the Y tree
/// has two streams and three adders, with yy. So the first bit takes no longer than in trees of degree 1. With w bits
/// per clock all delayed streams are aligned like the multiplicand; the node stores the last n-1-k bits of the slope
/// and passes on w of them.
///
/// If only every r-th level of a tree, and its last level, is followed by registers, r adders are chained within a
/// clock. The operands of a level must then arrive with the stream's bits of that clock, so all taps of a level are
/// earlier by the same number of clocks as the stream.
///
/// This model stores the coefficient bits that have entered, from which the contents of all registers follow.
class LinearEvaluator {
 public:
  /// `register_levels`: levels of a tree from one register to the next, at least 1.
  explicit LinearEvaluator(PlaneShape shape, unsigned register_levels = 1);

  /// Clocks from the roots to the pixels.
  [[nodiscard]] unsigned latency() const { return x_levels_.clocks() + y_levels_.clocks(); }
  [[nodiscard]] unsigned x_levels() const { return x_levels_.levels; }
  [[nodiscard]] unsigned y_levels() const { return y_levels_.levels; }

  /// Whether a bit is on its way to the pixels.
  [[nodiscard]] bool any_active() const { return active_ > 0; }

  /// Advances one clock. `leaves` are the registers at the pixels: they are written in clocks in which a bit reaches
  /// them, and keep their value otherwise. Returns whether a bit reached them. In trees without levels `leaves` are
  /// wires, which show `root` in the same clock. The bits of a stream enter in consecutive clocks, starting with bit 0.
  bool clock(const RootBits& root, StreamBit& leaves);

  /// Signals at a level of the X or Y tree on the path to a pixel, while `root` is on the wires. Level 0 is the root of
  /// the tree, the last level is its leaves. The leaves of the X tree enter the Y tree; those of the Y tree are the
  /// registers at the pixels.
  [[nodiscard]] LevelProbe x_level(unsigned level, std::uint32_t x, const RootBits& root) const;
  [[nodiscard]] LevelProbe y_level(unsigned level, Place pixel, const RootBits& root) const;

  /// Empties the trees.
  void clear();

 private:
  [[nodiscard]] StreamBit entering(const RootBits& root) const;
  [[nodiscard]] StreamBit at(unsigned clocks_ago, const RootBits& root) const;

  PlaneShape shape_;
  TreeDepth x_levels_;
  TreeDepth y_levels_;
  StreamBit last_;               ///< last active bits that entered
  std::vector<StreamBit> bits_;  ///< ring of the registers' contents
  std::size_t oldest_ = 0;
  unsigned active_ = 0;  ///< number of active entries of bits_
};

}  // namespace csgsim::array
