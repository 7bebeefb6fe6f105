#include "hw/array/linear_evaluator.h"

#include <algorithm>

namespace csgsim::array {

namespace {

/// The level's adder adds `multiplicand` to `stream` if the node, whose first leaf is `node`, has a right child.
LevelProbe probe_of(const StreamBit& bit, std::uint64_t stream, std::uint64_t multiplicand, bool has_adder) {
  if (!bit.token.active()) return {};
  const auto of = [&](std::uint64_t value) { return (value >> bit.token.bit & 1U) != 0; };
  return {.token = bit.token,
          .stream = of(stream),
          .carry = has_adder && of(stream ^ multiplicand ^ (stream + multiplicand))};
}

/// The first leaf of the node of a level, so many levels above the leaves, that covers that leaf.
std::uint32_t node_of(std::uint32_t leaf, unsigned below) { return leaf >> below << below; }

bool has_right_child(std::uint32_t node, unsigned below, std::uint32_t leaves) {
  return below > 0 && node + (std::uint64_t{1} << (below - 1)) < leaves;
}

}  // namespace

LinearEvaluator::LinearEvaluator(PlaneShape shape)
    : shape_(shape), x_levels_(tree_levels(shape.width)), y_levels_(tree_levels(shape.height)), bits_(levels()) {}

StreamBit LinearEvaluator::entering(const RootBits& root) const {
  if (!root.token.active()) return {};
  StreamBit bit = root.token.bit == 0 ? StreamBit{} : last_;
  bit.token = root.token;
  bit.a |= std::uint64_t{root.a} << root.token.bit;
  bit.b |= std::uint64_t{root.b} << root.token.bit;
  bit.c |= std::uint64_t{root.c} << root.token.bit;
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
  const StreamBit& reached = at(levels(), root);
  if (!reached.token.active()) return false;
  leaves = reached;
  return true;
}

/// Level k holds what entered k clocks ago.
StreamBit LinearEvaluator::at(unsigned level, const RootBits& root) const {
  if (level == 0) return entering(root);
  const std::size_t place = oldest_ + level - 1;
  return bits_[place < bits_.size() ? place : place - bits_.size()];
}

LevelProbe LinearEvaluator::x_level(unsigned level, std::uint32_t x, const RootBits& root) const {
  const StreamBit bit = at(level, root);
  const unsigned below = x_levels_ - level;
  const std::uint32_t node = node_of(x, below);
  return probe_of(bit, bit.a * node + bit.c, below == 0 ? 0 : bit.a << (below - 1),
                  has_right_child(node, below, shape_.width));
}

LevelProbe LinearEvaluator::y_level(unsigned level, Place pixel, const RootBits& root) const {
  const StreamBit bit = at(x_levels_ + level, root);
  const unsigned below = y_levels_ - level;
  const std::uint32_t node = node_of(pixel.y, below);
  return probe_of(bit, bit.a * pixel.x + bit.b * node + bit.c, below == 0 ? 0 : bit.b << (below - 1),
                  has_right_child(node, below, shape_.height));
}

void LinearEvaluator::clear() {
  std::fill(bits_.begin(), bits_.end(), StreamBit{});
  active_ = 0;
}

}  // namespace csgsim::array
