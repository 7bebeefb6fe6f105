#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hw/array/plane.h"
#include "hw/array/stream_bit.h"

namespace csgsim::array {

/// The token's bits of the coefficients of StreamBit, as the controller sends them, the first lowest; of trees of
/// degree 1 the last three are no wires.
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

/// ceil(log2(leaves)), 0 for one leaf.
constexpr unsigned tree_levels(std::uint32_t leaves) {
  unsigned levels = 0;
  while ((std::uint64_t{1} << levels) < leaves) ++levels;
  return levels;
}

/// What trees are built for.
struct TreeForm {
  unsigned degree = 1;           ///< of the expressions
  unsigned bits = 1;             ///< of a stream, side by side
  unsigned register_levels = 1;  ///< from one register to the next
};

/// A tree's levels, of which so many lie between two registers; behind the last there are registers in any case.
struct TreeDepth {
  unsigned levels = 0;
  unsigned between_registers = 1;

  /// From the root to a level, that of the leaves being number `levels`.
  [[nodiscard]] constexpr unsigned clocks_to(unsigned level) const {
    return level == levels ? clocks() : level / between_registers;
  }
  [[nodiscard]] constexpr unsigned clocks() const { return (levels + between_registers - 1) / between_registers; }
};

/// What is at a level of a tree on the way to a pixel, in the middle of a clock.
struct LevelProbe {
  Token token;               ///< of the bits that enter the level
  std::uint32_t stream = 0;  ///< those bits
  bool carry = false;        ///< that the level's adder, if there is a right child, adds to the first of them

  // Of trees of degree 2, the same for the slopes: what the value grows by from leaf to leaf but for the squares.
  std::uint32_t slope = 0;
  bool slope_carry = false;
  bool step_carry = false;       ///< of the adder that puts the squares to the slope
  std::uint32_t row_slope = 0;   ///< in the X tree: the slope along the column, with which the Y tree begins
  bool row_slope_carry = false;  ///< in the X tree
};

/// The Linear Expression Evaluator (thesis 7.2.1): an X tree over the columns, whose leaves A*x + C each enter a Y tree
/// over the rows. Bit j of A*x + B*y + C reaches the pixels latency() clocks after bit j of A, B and C entered, for
/// instructions of any width, back to back. In a clock w bits enter, 1 to 32; those of a stream's last clock may be
/// fewer.
///
/// A tree of n levels multiplies by the leaf's coordinate, one serial adder with carry and one delay a level. A node of
/// level k (root 0) covers 2^(n-k) leaves. It passes the incoming stream, one clock later, to its left child, and the
/// stream plus the multiplicand to its right child, whose leaves have coordinate bit n-1-k set. All levels share the
/// multiplicand wire. The stream reaches level k after k clocks and the multiplicand n-1 clocks after the stream's
/// first bit, so at level k it is worth 2^(n-1-k) times itself, and counts as 0 before.
///
/// In trees that take w bits a clock each adder is w bits wide and keeps the carry out of its highest. A factor of two
/// is then a bit and no longer a clock, so that each level has a tap of its own. To be worth 2^s times itself, s =
/// n-1-k, the multiplicand's bit j - s has to meet the stream's bit j at level k. The wires are tapped twice, floor(s /
/// w) clocks after they passed with the stream's bits and a clock later; of these 2w bits w are added, beginning s mod
/// w below the first of the later clock. So the wires are crossed s mod w places on their way to the level, once for
/// all its nodes. What comes before the multiplicand's first bit counts as 0. With w = 1 nothing is crossed, and the
/// taps of all levels are one.
///
/// Trees of degree 2 bring xx*x*x + xy*x*y + yy*y*y + a*x + b*y + c. A node of the X tree whose first leaf is X has
/// three streams, aligned: the value xx*X*X + a*X + c, the slope 2*xx*X + a and the row's slope xy*X + b. To its right
/// child, h = 2^(n-1-k) leaves on, it adds h*(slope + h*xx), 2*h*xx and h*xy, by four serial adders, of which those of
/// the value lie one behind the other in a clock. The slope is delayed n-1-k clocks at the node itself to be worth h
/// times itself; xx and xy come on wires which all nodes of a level share, delayed so that they are worth h*h, 2*h and
/// h times themselves. A node of the Y tree has two streams and three adders, with yy. So the first bit takes no longer
/// than in trees of degree 1. With w bits a clock all that is delayed is aligned as the multiplicand is; of the slope
/// the last n-1-k bits are kept at the node, w of which are in what it passes on.
///
/// Where there are registers behind every r-th level of a tree alone, and behind its last, r adders lie one behind the
/// other in a clock. What a level adds has then to come with the stream's bits of that clock: all taps of a level
/// are as many clocks earlier as the stream is.
///
/// What the registers hold follows from the coefficients' bits that have entered, which are kept instead of them.
class LinearEvaluator {
 public:
  /// `register_levels`: levels of a tree from one register to the next, 1 or more.
  explicit LinearEvaluator(PlaneShape shape, unsigned register_levels = 1);

  /// Clocks from the roots to the pixels.
  [[nodiscard]] unsigned latency() const { return x_levels_.clocks() + y_levels_.clocks(); }
  [[nodiscard]] unsigned x_levels() const { return x_levels_.levels; }
  [[nodiscard]] unsigned y_levels() const { return y_levels_.levels; }

  /// Is a bit on its way to the pixels?
  [[nodiscard]] bool any_active() const { return active_ > 0; }

  /// One clock. `leaves` are the registers at the pixels; they are written in clocks in which a bit reaches them, and
  /// hold otherwise. Returns whether one did. With no level at all `leaves` are wires: they show `root` at once. The
  /// bits of a stream enter clock after clock, the first with number 0.
  bool clock(const RootBits& root, StreamBit& leaves);

  /// What is at a level of the X or of the Y tree, while `root` is on the wires, on the way to a pixel. Level 0 is the
  /// tree's root; the last are its leaves: those of the X tree enter the Y tree, those of the Y tree are the registers
  /// at the pixels.
  [[nodiscard]] LevelProbe x_level(unsigned level, std::uint32_t x, const RootBits& root) const;
  [[nodiscard]] LevelProbe y_level(unsigned level, Place pixel, const RootBits& root) const;

  /// Empties the trees.
  void clear();

 private:
  [[nodiscard]] StreamBit entering(const RootBits& root) const;
  [[nodiscard]] StreamBit at(unsigned clocks, const RootBits& root) const;

  PlaneShape shape_;
  TreeDepth x_levels_;
  TreeDepth y_levels_;
  StreamBit last_;               ///< that entered
  std::vector<StreamBit> bits_;  ///< a ring: what has come to the registers
  std::size_t oldest_ = 0;
  unsigned active_ = 0;  ///< of them
};

}  // namespace csgsim::array
