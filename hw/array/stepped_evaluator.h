// Model of the linear expression evaluator, adder by adder.
// Used by hw/pixel_planes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"
#include "hw/array/stepped_tree.h"

namespace csgsim::array {

/// The trees of LinearEvaluator, modelled adder by adder. Outputs and signals at every level are equal to those of
/// LinearEvaluator in each clock, but are computed only from the bits that have passed through the adders.
class SteppedEvaluator {
 public:
  /// `shape` is that of the whole array. If `pixels` is not empty, only these pixels are built, side by side; then only
  /// their columns have Y trees.
  SteppedEvaluator(PlaneShape shape, TreeForm form, std::span<const Place> pixels = {});

  [[nodiscard]] bool any_active() const { return columns_.any_active() || rows_.any_active(); }

  /// Size of the bits at the pixels in the format of PixelArray: one plane for each bit that enters in a clock.
  [[nodiscard]] std::size_t leaf_words() const;

  /// Advances one clock. `leaves` has leaf_words() words, which are written in clocks in which bits reach the pixels.
  /// Returns the token of these bits, in the same clocks as LinearEvaluator::clock.
  Token clock(const RootBits& root, std::span<std::uint64_t> leaves);

  // Same signals as in LinearEvaluator; `pixel` must be one of the built pixels. Trees of degree 1 have no slopes.
  [[nodiscard]] LevelProbe x_level(unsigned level, std::uint32_t x, const RootBits& root) const;
  [[nodiscard]] LevelProbe y_level(unsigned level, Place pixel, const RootBits& root) const;

 private:
  [[nodiscard]] std::size_t find_lane(std::uint32_t x) const;
  [[nodiscard]] std::size_t plane_words() const;
  [[nodiscard]] TreeWires column_tree_wires(const RootBits& root) const;
  [[nodiscard]] TreeWires row_tree_wires(const RootBits& root) const;
  void copy_columns_to_lanes(const NodeBits& columns, NodeBits& row) const;
  void write_leaves(std::span<std::uint64_t> leaves) const;

  PlaneShape shape_;
  unsigned degree_;
  unsigned bits_;
  std::vector<Place> pixels_;  ///< empty if all are built
  std::vector<std::uint32_t> columns_of_lanes_;
  SteppedTree columns_;
  SteppedTree rows_;
  NodeStreams root_;  ///< streams that enter the X tree
  NodeStreams row_;   ///< streams that enter the Y trees
  Wire a_;
  Wire b_;
  Wire xx_;
  Wire xy_;
  Wire yy_;
  Wire none_;  ///< a wire that is always 0
};

}  // namespace csgsim::array
