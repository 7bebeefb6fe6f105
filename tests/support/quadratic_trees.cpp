#include "tests/support/quadratic_trees.h"

namespace csgsim::test {

namespace {

/// Valid for trees that take one bit per clock.
NodeStreams root_streams(const RootBits& root) {
  return {.value = root.c != 0, .slope = root.a != 0, .row_slope = root.b != 0};
}

}  // namespace

QuadraticWay::Tree::Tree(std::uint32_t leaves, std::uint32_t leaf) : tokens(array::tree_levels(leaves)) {
  for (unsigned k = 0; k < tokens.levels(); ++k) {
    const unsigned below = tokens.levels() - 1 - k;
    const std::uint64_t right = ((std::uint64_t{leaf} >> below) | 1U) << below;  // first leaf of the right child
    levels.push_back({.below = below,
                      .goes_right = ((leaf >> below) & 1U) != 0,
                      .has_adders = right < leaves,
                      .delayed_slope = DelayLine(below)});
  }
}

/// The deepest level comes first because each level takes the previous output of the level above.
void QuadraticWay::Tree::clock(Token token, NodeStreams in, const Wires& wires) {
  for (unsigned k = tokens.levels(); k-- > 0;) {
    const Token here = tokens.at(k, token);
    if (here.active()) clock_level(k, here, at(k, in), wires);
  }
  tokens.shift(token);
}

/// A stream delayed by d clocks is worth 2^d times the original and counts as 0 for the first d bits.
void QuadraticWay::Tree::clock_level(unsigned level_index, Token token, NodeStreams in, const Wires& wires) {
  Level& level = levels[level_index];
  const auto times = [&](unsigned delay, bool bit) { return token.bit >= static_cast<int>(delay) && bit; };
  const unsigned half = level.below;
  const unsigned depth = tokens.levels();
  const bool slope = times(half, level.delayed_slope.out(in.slope));
  const bool square = times(2 * half, wires.square.at(wires.ahead + level_index + 2 * half, wires.square_in));
  const bool twice = times(half + 1, wires.square.at(wires.ahead + depth, wires.square_in));
  const bool cross = times(half, wires.cross.at(wires.ahead + depth - 1, wires.cross_in));
  level.delayed_slope.shift(in.slope);
  if (token.bit == 0) level.value.carry = level.step.carry = level.slope.carry = level.row_slope.carry = false;
  level.out = in;
  if (!level.has_adders) return;
  const NodeStreams right{.value = level.value.add(in.value, level.step.add(slope, square)),
                          .slope = level.slope.add(in.slope, twice),
                          .row_slope = level.row_slope.add(in.row_slope, cross)};
  if (level.goes_right) level.out = right;
}

LevelProbe QuadraticWay::Tree::probe(unsigned level, Token token, NodeStreams in) const {
  const Token here = tokens.at(level, token);
  const NodeStreams streams = at(level, in);
  LevelProbe probe{.token = here, .stream = streams.value, .slope = streams.slope, .row_slope = streams.row_slope};
  if (level == tokens.levels() || here.bit <= 0) return probe;
  probe.carry = levels[level].value.carry;
  probe.step_carry = levels[level].step.carry;
  probe.slope_carry = levels[level].slope.carry;
  probe.row_slope_carry = levels[level].row_slope.carry;
  return probe;
}

QuadraticWay::QuadraticWay(PlaneShape shape, Place pixel)
    : columns_(shape.width, pixel.x), rows_(shape.height, pixel.y) {}

/// The Y tree starts with the column's value and the column's slope.
NodeStreams QuadraticWay::row_streams(const RootBits& root) const {
  const NodeStreams column = columns_.at(columns_.tokens.levels(), root_streams(root));
  return {.value = column.value, .slope = column.row_slope};
}

/// The Y tree comes first because it takes the previous output of the X tree.
void QuadraticWay::clock(const RootBits& root) {
  const Token between = columns_.tokens.leaves(root.token);
  rows_.clock(between, row_streams(root), {yy_, TappedWire(), root.yy != 0, false, columns_.tokens.levels()});
  columns_.clock(root.token, root_streams(root), {xx_, xy_, root.xx != 0, root.xy != 0, 0});
  xx_.shift(root.xx);
  xy_.shift(root.xy);
  yy_.shift(root.yy);
}

LevelProbe QuadraticWay::x_level(unsigned level, const RootBits& root) const {
  return columns_.probe(level, root.token, root_streams(root));
}

LevelProbe QuadraticWay::y_level(unsigned level, const RootBits& root) const {
  return rows_.probe(level, columns_.tokens.leaves(root.token), row_streams(root));
}

}  // namespace csgsim::test
