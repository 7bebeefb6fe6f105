#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hw/array/linear_evaluator.h"
#include "hw/array/plane.h"
#include "hw/array/stepped_tree.h"

namespace csgsim::array {

/// The trees of LinearEvaluator adder by adder: what reaches the pixels, at which clock, and what is at every level is
/// the same, but comes of the bits that have gone through the adders, and of nothing else.
class SteppedEvaluator {
 public:
  /// `shape`: of the whole array. `pixels`, unless there are none: those alone, side by side; then only their columns
  /// have Y trees.
  SteppedEvaluator(PlaneShape shape, TreeForm form, std::span<const Place> pixels = {});

  [[nodiscard]] bool any_active() const { return columns_.any_active() || rows_.any_active(); }

  /// The bits at the pixels, as a PixelArray has them: a plane of each that enters in a clock.
  [[nodiscard]] std::size_t leaf_words() const;

  /// One clock. `leaves`, leaf_words() of them, are written in clocks in which bits reach the pixels. Returns which
  /// did, as LinearEvaluator::clock.
  Token clock(const RootBits& root, std::span<std::uint64_t> leaves);

  // As those of LinearEvaluator; the pixel has to be one that is built. Of degree 1 there are no slopes.
  [[nodiscard]] LevelProbe x_level(unsigned level, std::uint32_t x, const RootBits& root) const;
  [[nodiscard]] LevelProbe y_level(unsigned level, Place pixel, const RootBits& root) const;

 private:
  [[nodiscard]] std::size_t lane_of(std::uint32_t x) const;
  [[nodiscard]] std::size_t plane_words() const;
  [[nodiscard]] TreeWires to_columns(const RootBits& root) const;
  [[nodiscard]] TreeWires to_rows(const RootBits& root) const;
  void gather(const NodeBits& columns, NodeBits& row) const;
  void put_leaves(std::span<std::uint64_t> leaves) const;

  PlaneShape shape_;
  unsigned degree_;
  unsigned bits_;
  std::vector<Place> pixels_;  ///< empty if all are built
  std::vector<std::uint32_t> columns_of_lanes_;
  SteppedTree columns_;
  SteppedTree rows_;
  NodeStreams root_;  ///< that enter the X tree
  NodeStreams row_;   ///< that enter the Y trees
  Wire a_;
  Wire b_;
  Wire xx_;
  Wire xy_;
  Wire yy_;
  Wire none_;  ///< that nothing comes on
};

}  // namespace csgsim::array
