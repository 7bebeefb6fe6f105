#include "hw/array/stepped_tree.h"

#include <algorithm>

namespace csgsim::array {

namespace {

std::uint64_t spread(bool bit) { return bit ? ~std::uint64_t{0} : 0; }

bool bit_at(const Words& words, std::size_t word, std::size_t lane) {
  return !words.empty() && (words[word + lane / word_bits] >> (lane % word_bits) & 1U) != 0;
}

/// A serial adder a lane: the sum's bit. The carry is that of the bit before, then of this one.
std::uint64_t add_bit(std::uint64_t one, std::uint64_t other, std::uint64_t& carry) {
  const std::uint64_t half = one ^ other;
  const std::uint64_t sum = half ^ carry;
  carry = (one & other) | (half & carry);
  return sum;
}

/// A carry before the first bit of a stream is 0, whatever the stream before has left.
void begin(Token here, Words& carry) {
  if (here.bit == 0) std::fill(carry.begin(), carry.end(), 0);
}

}  // namespace

SteppedTree::SteppedTree(std::uint32_t leaves, std::size_t node_words, unsigned degree, bool has_rows)
    : node_words_(node_words), degree_(degree), has_rows_(has_rows), tokens_(tree_levels(leaves)) {
  const auto depth = static_cast<unsigned>(tokens_.size());
  const auto nodes_at = [&](unsigned level) {
    const unsigned below = depth - level;
    return (leaves + (std::size_t{1} << below) - 1) >> below;
  };
  for (unsigned k = 0; k < depth; ++k) {
    Level& level = levels_.emplace_back();
    level.below = depth - 1 - k;
    level.nodes = nodes_at(k);
    const std::size_t children = nodes_at(k + 1);
    level.pairs = children - level.nodes;
    const std::size_t pairs = level.pairs * node_words;
    level.value_carry.resize(pairs);
    level.out.value.resize(children * node_words);
    if (degree < 2) continue;
    level.step_carry.resize(pairs);
    level.slope_carry.resize(pairs);
    level.out.slope.resize(children * node_words);
    level.delayed.assign(level.below, Words(level.nodes * node_words));
    if (!has_rows) continue;
    level.row_carry.resize(pairs);
    level.out.row_slope.resize(children * node_words);
  }
}

bool SteppedTree::any_active() const {
  return std::any_of(tokens_.begin(), tokens_.end(), [](Token token) { return token.active(); });
}

/// The deepest level first: each takes what the one above has left the clock before.
void SteppedTree::clock(Token token, const NodeStreams& root, const TreeWires& wires) {
  for (unsigned k = levels(); k-- > 0;) {
    const Token here = token_at(k, token);
    if (!here.active()) continue;
    if (degree_ < 2) {
      const bool counts = here.bit >= static_cast<int>(levels_[k].below);
      add(levels_[k], here, at(k, root), counts && wires.multiplicand.at(levels() - 1));
    } else {
      add_squares(k, here, at(k, root), wires);
    }
  }
  if (tokens_.empty()) return;
  std::shift_right(tokens_.begin(), tokens_.end(), 1);
  tokens_.front() = token;
}

/// The left children, and the right one of no pair, get what comes in. Of a level the nodes with a right child are the
/// first ones, all but perhaps the last.
void SteppedTree::pass(const Level& level, const Words& in, Words& out) const {
  for (std::size_t node = 0; node < level.nodes; ++node)
    std::copy_n(&in[node * node_words_], node_words_, &out[2 * node * node_words_]);
}

void SteppedTree::add(Level& level, Token here, const NodeStreams& in, bool multiplicand) const {
  pass(level, in.value, level.out.value);
  begin(here, level.value_carry);
  const std::uint64_t addend = spread(multiplicand);
  for (std::size_t node = 0; node < level.pairs; ++node) {
    const std::uint64_t* const value = &in.value[node * node_words_];
    std::uint64_t* const carry = &level.value_carry[node * node_words_];
    std::uint64_t* const right = &level.out.value[(2 * node + 1) * node_words_];
    for (std::size_t word = 0; word < node_words_; ++word) right[word] = add_bit(value[word], addend, carry[word]);
  }
}

/// What entered the nodes' delay lines `below` clocks ago; `slope` enters now.
const Words& SteppedTree::delayed_slope(Level& level, const Words& slope) const {
  if (level.below == 0) return slope;
  return level.delayed[level.oldest];
}

/// A stream that comes d clocks late is worth 2^d times itself, and counts as 0 for its first d bits.
void SteppedTree::add_squares(unsigned k, Token here, const NodeStreams& in, const TreeWires& wires) {
  Level& level = levels_[k];
  const unsigned half = level.below;
  const auto counts = [&](unsigned delay) { return here.bit >= static_cast<int>(delay); };
  const std::uint64_t slope_counts = spread(counts(half));
  const std::uint64_t square = spread(counts(2 * half) && wires.square.at(k + 2 * half));
  const std::uint64_t twice = spread(counts(half + 1) && wires.square.at(levels()));
  const std::uint64_t cross = spread(has_rows_ && counts(half) && wires.cross.at(levels() - 1));
  const Words& delayed = delayed_slope(level, in.slope);
  pass(level, in.value, level.out.value);
  pass(level, in.slope, level.out.slope);
  if (has_rows_) pass(level, in.row_slope, level.out.row_slope);
  for (Words* const carry : {&level.value_carry, &level.step_carry, &level.slope_carry, &level.row_carry})
    begin(here, *carry);
  for (std::size_t node = 0; node < level.pairs; ++node) {
    const std::size_t right = (2 * node + 1) * node_words_;
    for (std::size_t word = 0; word < node_words_; ++word) {
      const std::size_t at = node * node_words_ + word;
      const std::uint64_t step = add_bit(delayed[at] & slope_counts, square, level.step_carry[at]);
      level.out.value[right + word] = add_bit(in.value[at], step, level.value_carry[at]);
      level.out.slope[right + word] = add_bit(in.slope[at], twice, level.slope_carry[at]);
      if (has_rows_) level.out.row_slope[right + word] = add_bit(in.row_slope[at], cross, level.row_carry[at]);
    }
  }
  if (half == 0) return;
  std::copy_n(in.slope.begin(), level.nodes * node_words_, level.delayed[level.oldest].begin());
  level.oldest = level.oldest + 1 == half ? 0 : level.oldest + 1;
}

LevelProbe SteppedTree::probe(unsigned level, std::uint32_t leaf, std::size_t lane, Token token,
                              const NodeStreams& root) const {
  const Token here = token_at(level, token);
  if (!here.active()) return {};
  const NodeStreams& in = at(level, root);
  const std::size_t node = leaf >> (levels() - level);
  const std::size_t word = node * node_words_;
  LevelProbe probe{.token = here,
                   .stream = bit_at(in.value, word, lane),
                   .slope = bit_at(in.slope, word, lane),
                   .row_slope = bit_at(in.row_slope, word, lane)};
  if (level == levels() || here.bit == 0 || node >= levels_[level].pairs) return probe;
  probe.carry = bit_at(levels_[level].value_carry, word, lane);
  probe.step_carry = bit_at(levels_[level].step_carry, word, lane);
  probe.slope_carry = bit_at(levels_[level].slope_carry, word, lane);
  probe.row_slope_carry = bit_at(levels_[level].row_carry, word, lane);
  return probe;
}

}  // namespace csgsim::array
