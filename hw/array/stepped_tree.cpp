#include "hw/array/stepped_tree.h"

#include <algorithm>

namespace csgsim::array {

namespace {

std::uint64_t spread(std::uint32_t bits, unsigned bit) { return (bits >> bit & 1U) != 0 ? ~std::uint64_t{0} : 0; }

bool bit_at(const Words& words, std::size_t word, std::size_t lane) {
  return !words.empty() && (words[word + lane / word_bits] >> (lane % word_bits) & 1U) != 0;
}

/// The token's bits in one lane.
std::uint32_t bits_at(const NodeBits& planes, Token token, std::size_t word, std::size_t lane) {
  std::uint32_t bits = 0;
  for (std::size_t bit = 0; bit < token.bits && bit < planes.size(); ++bit)
    bits |= static_cast<std::uint32_t>(bit_at(planes[bit], word, lane)) << bit;
  return bits;
}

/// One serial adder per lane. Returns the sum bit; replaces the carry in by the carry out.
std::uint64_t add_bit(std::uint64_t one, std::uint64_t other, std::uint64_t& carry) {
  const std::uint64_t half = one ^ other;
  const std::uint64_t sum = half ^ carry;
  carry = (one & other) | (half & carry);
  return sum;
}

/// Clears the carry if the token is at the first bit of a stream.
void begin(Token here, Words& carry) {
  if (here.bit == 0) std::fill(carry.begin(), carry.end(), 0);
}

}  // namespace

SteppedTree::SteppedTree(std::uint32_t leaves, std::size_t node_words, TreeForm form, bool has_rows)
    : node_words_(node_words),
      form_(form),
      has_rows_(has_rows),
      depth_{tree_levels(leaves), form.register_levels},
      tokens_(depth_.clocks()) {
  const unsigned depth = depth_.levels;
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
    const NodeBits registers(form.bits, Words(children * node_words));
    level.value_carry.resize(pairs);
    level.out.value = registers;
    if (form.degree < 2) continue;
    level.step_carry.resize(pairs);
    level.slope_carry.resize(pairs);
    level.out.slope = registers;
    level.delayed.assign((level.below + form.bits - 1) / form.bits,
                         NodeBits(form.bits, Words(level.nodes * node_words)));
    if (!has_rows) continue;
    level.row_carry.resize(pairs);
    level.out.row_slope = registers;
  }
}

bool SteppedTree::any_active() const {
  return std::any_of(tokens_.begin(), tokens_.end(), [](Token token) { return token.active(); });
}

/// The deepest registers are written first, because each stage reads what the stage above produced one clock earlier.
/// Levels without registers between them are chained within the clock.
void SteppedTree::clock(Token token, const NodeStreams& root, const TreeWires& wires) {
  for (unsigned stage = clocks(); stage-- > 0;) {
    const unsigned first = stage * depth_.between_registers;
    const Token here = token_at(first, token);
    if (!here.active()) continue;
    for (unsigned k = first; k < std::min(first + depth_.between_registers, levels()); ++k)
      clock_level(k, here, at(k, root), wires);
  }
  if (tokens_.empty()) return;
  std::shift_right(tokens_.begin(), tokens_.end(), 1);
  tokens_.front() = token;
}

void SteppedTree::clock_level(unsigned level_number, Token token, const NodeStreams& in, const TreeWires& wires) {
  if (form_.degree >= 2) return clock_quadratic_level(level_number, token, in, wires);
  clock_linear_level(
      levels_[level_number], token, in,
      weighted_bits(wires.multiplicand, depth_.clocks_to(level_number), levels_[level_number].below, token));
}

/// The bits of a shared wire that match the token's bits at a level `clocks` clocks after the roots, where they have
/// weight 2^weight_log2. They are combined from two taps one clock apart; before the stream's first bit they are 0.
std::uint32_t SteppedTree::weighted_bits(const Tap& tap, unsigned clocks, unsigned weight_log2, Token token) const {
  const unsigned late = clocks + weight_log2 / form_.bits;
  const unsigned crossed = weight_log2 % form_.bits;
  std::uint64_t bits = std::uint64_t{tap.at(late)} << crossed;
  if (crossed > 0) bits |= tap.at(late + 1) >> (form_.bits - crossed);
  const auto first = static_cast<unsigned>(token.bit);
  const unsigned before = first < weight_log2 ? weight_log2 - first : 0;
  return static_cast<std::uint32_t>(bits & low_bits(form_.bits) & ~low_bits(before));
}

/// Passes the incoming bits to the left children. Nodes with a right child come first in a level; only the last node
/// may have none.
void SteppedTree::pass_to_left_children(const Level& level, Token token, const NodeBits& in, NodeBits& out) const {
  for (unsigned bit = 0; bit < token.bits; ++bit) {
    for (std::size_t node = 0; node < level.nodes; ++node)
      std::copy_n(&in[bit][node * node_words_], node_words_, &out[bit][2 * node * node_words_]);
  }
}

void SteppedTree::clock_linear_level(Level& level, Token token, const NodeStreams& in,
                                     std::uint32_t multiplicand) const {
  pass_to_left_children(level, token, in.value, level.out.value);
  begin(token, level.value_carry);
  for (unsigned bit = 0; bit < token.bits; ++bit) {
    const std::uint64_t addend = spread(multiplicand, bit);
    for (std::size_t node = 0; node < level.pairs; ++node) {
      const std::uint64_t* const value = &in.value[bit][node * node_words_];
      std::uint64_t* const carry = &level.value_carry[node * node_words_];
      std::uint64_t* const right = &level.out.value[bit][(2 * node + 1) * node_words_];
      for (std::size_t word = 0; word < node_words_; ++word) right[word] = add_bit(value[word], addend, carry[word]);
    }
  }
}

/// Position of the slope bit `below` places before stream bit `stream_bit`; empty before the first bit.
std::optional<SteppedTree::Delayed> SteppedTree::delayed_bit(const Level& level, int stream_bit) const {
  const int wanted = stream_bit - static_cast<int>(level.below);
  if (wanted < 0) return std::nullopt;
  const auto width = static_cast<int>(form_.bits);
  return Delayed{static_cast<std::size_t>(stream_bit / width - wanted / width),
                 static_cast<std::size_t>(wanted % width)};
}

/// The entry of the ring that was written `clocks_ago` clocks ago; `clocks_ago` is at least 1.
const NodeBits& SteppedTree::slopes_entered(const Level& level, std::size_t clocks_ago) {
  return level.delayed[(level.oldest + level.delayed.size() - clocks_ago) % level.delayed.size()];
}

/// The plane of the slope bit, null before the first bit; `slope` is the entry of this clock.
const Words* SteppedTree::delayed_slope(const Level& level, int stream_bit, const NodeBits& slope) const {
  const std::optional<Delayed> delayed = delayed_bit(level, stream_bit);
  if (!delayed) return nullptr;
  return delayed->clocks == 0 ? &slope[delayed->plane] : &slopes_entered(level, delayed->clocks)[delayed->plane];
}

void SteppedTree::delay_slope(Level& level, const NodeBits& slope) const {
  if (level.delayed.empty()) return;
  NodeBits& oldest = level.delayed[level.oldest];
  for (unsigned bit = 0; bit < form_.bits; ++bit)
    std::copy_n(slope[bit].begin(), level.nodes * node_words_, oldest[bit].begin());
  level.oldest = (level.oldest + 1) % level.delayed.size();
}

/// A stream delayed by n places has weight 2^n and counts as 0 before its first bit.
void SteppedTree::clock_quadratic_level(unsigned level_number, Token token, const NodeStreams& in,
                                        const TreeWires& wires) {
  Level& level = levels_[level_number];
  const unsigned half = level.below;
  const unsigned clocks = depth_.clocks_to(level_number);
  const std::uint32_t square = weighted_bits(wires.square, clocks, 2 * half, token);
  const std::uint32_t twice = weighted_bits(wires.square, clocks, half + 1, token);
  const std::uint32_t cross = has_rows_ ? weighted_bits(wires.cross, clocks, half, token) : 0;
  pass_to_left_children(level, token, in.value, level.out.value);
  pass_to_left_children(level, token, in.slope, level.out.slope);
  if (has_rows_) pass_to_left_children(level, token, in.row_slope, level.out.row_slope);
  for (Words* const carry : {&level.value_carry, &level.step_carry, &level.slope_carry, &level.row_carry})
    begin(token, *carry);
  for (unsigned bit = 0; bit < token.bits; ++bit) {
    const Words* const delayed = delayed_slope(level, token.bit + static_cast<int>(bit), in.slope);
    for (std::size_t node = 0; node < level.pairs; ++node) {
      const std::size_t right = (2 * node + 1) * node_words_;
      for (std::size_t word = 0; word < node_words_; ++word) {
        const std::size_t at = node * node_words_ + word;
        const std::uint64_t slope = delayed == nullptr ? 0 : (*delayed)[at];
        const std::uint64_t step = add_bit(slope, spread(square, bit), level.step_carry[at]);
        level.out.value[bit][right + word] = add_bit(in.value[bit][at], step, level.value_carry[at]);
        level.out.slope[bit][right + word] = add_bit(in.slope[bit][at], spread(twice, bit), level.slope_carry[at]);
        if (has_rows_)
          level.out.row_slope[bit][right + word] =
              add_bit(in.row_slope[bit][at], spread(cross, bit), level.row_carry[at]);
      }
    }
  }
  delay_slope(level, in.slope);
}

SteppedTree::LaneBits SteppedTree::lane_bits(const NodeStreams& in, Token token, std::size_t node,
                                             std::size_t lane) const {
  const std::size_t word = node * node_words_;
  return {bits_at(in.value, token, word, lane), bits_at(in.slope, token, word, lane),
          bits_at(in.row_slope, token, word, lane)};
}

/// The bits of a node's slope `below` places before the token's bits.
std::uint32_t SteppedTree::delayed_slope_bits(const Level& level, std::size_t node, std::size_t lane, Token token,
                                              std::uint32_t slope) const {
  std::uint32_t bits = 0;
  for (unsigned bit = 0; bit < token.bits; ++bit) {
    const std::optional<Delayed> delayed = delayed_bit(level, token.bit + static_cast<int>(bit));
    if (!delayed) continue;
    const bool is_set = delayed->clocks == 0
                            ? (slope >> delayed->plane & 1U) != 0
                            : bit_at(slopes_entered(level, delayed->clocks)[delayed->plane], node * node_words_, lane);
    bits |= static_cast<std::uint32_t>(is_set) << bit;
  }
  return bits;
}

/// Outputs of a node's adders for its right child, before the end of the clock.
SteppedTree::LaneBits SteppedTree::right_child(unsigned level_number, std::size_t node, std::size_t lane, Token token,
                                               LaneBits in, const TreeWires& wires) const {
  const Level& level = levels_[level_number];
  const unsigned half = level.below;
  const unsigned clocks = depth_.clocks_to(level_number);
  const auto sum = [&](std::uint32_t one, std::uint32_t other, const Words& carries) {
    const bool carry = token.bit > 0 && bit_at(carries, node * node_words_, lane);
    return static_cast<std::uint32_t>((std::uint64_t{one} + other + (carry ? 1U : 0U)) & low_bits(token.bits));
  };
  const auto tapped = [&](const Tap& tap, unsigned places) {
    return static_cast<std::uint32_t>(weighted_bits(tap, clocks, places, token) & low_bits(token.bits));
  };
  if (form_.degree < 2) return {.value = sum(in.value, tapped(wires.multiplicand, half), level.value_carry)};
  const std::uint32_t step =
      sum(delayed_slope_bits(level, node, lane, token, in.slope), tapped(wires.square, 2 * half), level.step_carry);
  LaneBits out{.value = sum(in.value, step, level.value_carry),
               .slope = sum(in.slope, tapped(wires.square, half + 1), level.slope_carry)};
  if (has_rows_) out.row_slope = sum(in.row_slope, tapped(wires.cross, half), level.row_carry);
  return out;
}

/// Starts at the last registers before the level and follows the streams through the adders from there to the level.
LevelProbe SteppedTree::probe(unsigned level, std::uint32_t leaf, std::size_t lane, Token token,
                              const NodeStreams& root, const TreeWires& wires) const {
  const Token here = token_at(level, token);
  if (!here.active()) return {};
  const auto node_of = [&](unsigned at_level) { return std::size_t{leaf >> (levels() - at_level)}; };
  unsigned k = level == levels() ? level : level - level % depth_.between_registers;
  LaneBits bits = lane_bits(at(k, root), here, node_of(k), lane);
  for (; k < level; ++k)
    if (node_of(k + 1) % 2 == 1) bits = right_child(k, node_of(k), lane, here, bits, wires);
  LevelProbe probe{.token = here, .stream = bits.value, .slope = bits.slope, .row_slope = bits.row_slope};
  const std::size_t node = node_of(level);
  if (level == levels() || here.bit == 0 || node >= levels_[level].pairs) return probe;
  const auto carry = [&](const Words& carries) { return bit_at(carries, node * node_words_, lane); };
  probe.carry = carry(levels_[level].value_carry);
  probe.step_carry = carry(levels_[level].step_carry);
  probe.slope_carry = carry(levels_[level].slope_carry);
  probe.row_slope_carry = carry(levels_[level].row_carry);
  return probe;
}

}  // namespace csgsim::array
