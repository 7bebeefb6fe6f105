#include "hw/array/linear_evaluator.h"

#include <algorithm>

namespace csgsim::array {

namespace {

/// Values of a node's streams: the value at its first leaf, its growth to the next leaf without the square term, the
/// square coefficient, and in the X tree the slope along the column.
struct Node {
  std::uint64_t value = 0;
  std::uint64_t slope = 0;
  std::uint64_t square = 0;
  std::uint64_t row_slope = 0;
  std::uint64_t cross = 0;  ///< growth of row_slope from leaf to leaf
};

/// `half`: distance in leaves to the right child; 0 if there is none.
LevelProbe make_probe(const StreamBit& bit, const Node& node, std::uint64_t half) {
  if (!bit.token.active()) return {};
  const auto of = [&](std::uint64_t value) { return bit.token.of(value); };
  const auto carry = [&](std::uint64_t one, std::uint64_t other) {
    return (of(one ^ other ^ (one + other)) & 1U) != 0;
  };
  const std::uint64_t slope = node.slope * half;
  const std::uint64_t square = node.square * half * half;
  return {.token = bit.token,
          .stream = of(node.value),
          .carry = carry(node.value, slope + square),
          .slope = of(node.slope),
          .slope_carry = carry(node.slope, 2 * half * node.square),
          .step_carry = carry(slope, square),
          .row_slope = of(node.row_slope),
          .row_slope_carry = carry(node.row_slope, half * node.cross)};
}

/// First leaf of the node that covers `leaf` and lies `below` levels above the leaves.
std::uint32_t first_leaf(std::uint32_t leaf, unsigned below) { return leaf >> below << below; }

/// Distance in leaves from the node's first leaf to that of its right child; 0 if it has no right child.
std::uint64_t child_distance(std::uint32_t node, unsigned below, std::uint32_t leaves) {
  const std::uint64_t half = below == 0 ? 0 : std::uint64_t{1} << (below - 1);
  return node + half < leaves ? half : 0;
}

}  // namespace

LinearEvaluator::LinearEvaluator(PlaneShape shape, unsigned register_levels)
    : shape_(shape),
      x_levels_{tree_levels(shape.width), register_levels},
      y_levels_{tree_levels(shape.height), register_levels},
      bits_(latency()) {}

StreamBit LinearEvaluator::entering(const RootBits& root) const {
  if (!root.token.active()) return {};
  StreamBit bit = root.token.bit == 0 ? StreamBit{} : last_;
  bit.token = root.token;
  bit.a |= std::uint64_t{root.a} << root.token.bit;
  bit.b |= std::uint64_t{root.b} << root.token.bit;
  bit.c |= std::uint64_t{root.c} << root.token.bit;
  bit.xx |= std::uint64_t{root.xx} << root.token.bit;
  bit.xy |= std::uint64_t{root.xy} << root.token.bit;
  bit.yy |= std::uint64_t{root.yy} << root.token.bit;
  return bit;
}

bool LinearEvaluator::clock(const RootBits& root, StreamBit& leaves) {
  const StreamBit entered = entering(root);
  if (entered.token.active()) last_ = entered;
  if (bits_.empty()) {
    if (entered.token.active()) leaves = entered;
    return entered.token.active();
  }
  if (!entered.token.active() && active_ == 0) return false;
  const std::size_t newest = oldest_ == 0 ? bits_.size() - 1 : oldest_ - 1;
  oldest_ = newest;
  const bool had = bits_[newest].token.active();
  bits_[newest] = entered;
  active_ += (entered.token.active() ? 1U : 0U);
  active_ -= had ? 1U : 0U;
  const StreamBit& reached = at(latency(), root);
  if (!reached.token.active()) return false;
  leaves = reached;
  return true;
}

/// The bits that entered `clocks_ago` clocks ago; those that enter now for 0.
StreamBit LinearEvaluator::at(unsigned clocks_ago, const RootBits& root) const {
  if (clocks_ago == 0) return entering(root);
  const std::size_t place = oldest_ + clocks_ago - 1;
  return bits_[place < bits_.size() ? place : place - bits_.size()];
}

LevelProbe LinearEvaluator::x_level(unsigned level, std::uint32_t x, const RootBits& root) const {
  const StreamBit bit = at(x_levels_.clocks_to(level), root);
  const unsigned below = x_levels_.levels - level;
  const std::uint32_t node = first_leaf(x, below);
  return make_probe(bit,
                    {.value = value_at(bit, node, 0),
                     .slope = 2 * bit.xx * node + bit.a,
                     .square = bit.xx,
                     .row_slope = bit.xy * node + bit.b,
                     .cross = bit.xy},
                    child_distance(node, below, shape_.width));
}

LevelProbe LinearEvaluator::y_level(unsigned level, Place pixel, const RootBits& root) const {
  const StreamBit bit = at(x_levels_.clocks() + y_levels_.clocks_to(level), root);
  const unsigned below = y_levels_.levels - level;
  const std::uint32_t node = first_leaf(pixel.y, below);
  return make_probe(
      bit,
      {.value = value_at(bit, pixel.x, node), .slope = bit.xy * pixel.x + 2 * bit.yy * node + bit.b, .square = bit.yy},
      child_distance(node, below, shape_.height));
}

void LinearEvaluator::clear() {
  std::fill(bits_.begin(), bits_.end(), StreamBit{});
  active_ = 0;
}

}  // namespace csgsim::array
