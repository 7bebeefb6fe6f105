#include "tests/support/probed_trees.h"

#include <algorithm>

namespace csgsim::test {

namespace {

using array::tree_levels;
using array::word_bits;

std::vector<std::uint32_t> coordinates(std::span<const Place> pixels, std::uint32_t Place::*axis) {
  std::vector<std::uint32_t> result;
  for (const Place& pixel : pixels) result.push_back(pixel.*axis);
  return result;
}

std::size_t words_of(std::size_t pixels) { return PlaneShape{static_cast<std::uint32_t>(pixels), 1}.padded_words(); }

bool bit_at(const Words& words, std::size_t i) { return ((words[i / word_bits] >> (i % word_bits)) & 1U) != 0; }

void set_bit(Words& words, std::size_t i, bool value) {
  words[i / word_bits] |= std::uint64_t{value} << (i % word_bits);
}

unsigned less_one(unsigned levels) { return levels == 0 ? 0 : levels - 1; }

}  // namespace

bool LevelTokens::any_active() const {
  return std::any_of(tokens_.begin(), tokens_.end(), [](Token token) { return token.active(); });
}

void LevelTokens::shift(Token root) {
  if (tokens_.empty()) return;
  std::shift_right(tokens_.begin(), tokens_.end(), 1);
  tokens_.front() = root;
}

void LevelTokens::clear() { std::fill(tokens_.begin(), tokens_.end(), Token{}); }

ProbedTrees::Tree::Tree(std::uint32_t leaves, std::span<const std::uint32_t> ways) : tokens(tree_levels(leaves)) {
  const std::size_t words = words_of(ways.size());
  for (unsigned k = 0; k < tokens.levels(); ++k) {
    Level& level = levels.emplace_back(Level{Words(words), Words(words), Words(words), Words(words)});
    const unsigned below = tokens.levels() - 1 - k;  // levels below its children
    for (std::size_t i = 0; i < ways.size(); ++i) {
      set_bit(level.goes_right, i, ((ways[i] >> below) & 1U) != 0);
      const std::uint64_t right = ((std::uint64_t{ways[i]} >> below) | 1U) << below;  // first leaf of the right child
      set_bit(level.has_adder, i, right < leaves);
    }
  }
}

void ProbedTrees::Tree::clock(Token token, std::span<const std::uint64_t> in, bool multiplicand) {
  for (unsigned k = tokens.levels(); k-- > 0;) {
    const Token here = tokens.at(k, token);
    if (!here.active()) continue;
    Level& level = levels[k];
    const bool adds = multiplicand && tokens.multiplies(k, here);
    const std::span<const std::uint64_t> from = k == 0 ? in : std::span<const std::uint64_t>(levels[k - 1].out);
    for (std::size_t word = 0; word < from.size(); ++word) {
      const std::uint64_t stream = from[word];
      const std::uint64_t carry = here.bit == 0 ? 0 : level.carry[word];
      const std::uint64_t addend = adds ? level.has_adder[word] : 0;
      const std::uint64_t sum = stream ^ carry ^ addend;
      level.carry[word] = ((stream & carry) | (addend & (stream | carry))) & level.has_adder[word];
      level.out[word] = (stream & ~level.goes_right[word]) | (sum & level.goes_right[word]);
    }
  }
  tokens.shift(token);
}

ProbedTrees::ProbedTrees(PlaneShape shape, std::span<const Place> pixels)
    : columns_(shape.width, coordinates(pixels, &Place::x)),
      rows_(shape.height, coordinates(pixels, &Place::y)),
      a_(less_one(x_levels())),
      b_(less_one(levels())),
      root_(words_of(pixels.size())) {}

bool ProbedTrees::clock(const RootBits& root, std::span<std::uint64_t> leaves) {
  if (!root.token.active() && !any_active()) return false;
  const bool a = a_.out(root.a);
  const bool b = b_.out(root.b);
  a_.shift(root.a);
  b_.shift(root.b);
  std::fill(root_.begin(), root_.end(), root.c ? ~std::uint64_t{0} : 0);
  const bool has_rows = y_levels() > 0;
  const Token between = columns_.tokens.leaves(root.token);
  if (has_rows) rows_.clock(between, x_levels() == 0 ? root_ : columns_.levels.back().out, b);
  columns_.clock(root.token, root_, a);
  const Token reached = has_rows ? rows_.tokens.leaves(between) : columns_.tokens.leaves(root.token);
  if (!reached.active()) return false;
  const Words& last = has_rows ? rows_.levels.back().out : x_levels() == 0 ? root_ : columns_.levels.back().out;
  std::copy(last.begin(), last.end(), leaves.begin());
  return true;
}

LevelProbe ProbedTrees::Tree::probe(unsigned level, std::uint32_t pixel, Token token, bool stream) const {
  const Token here = tokens.at(level, token);
  return {.token = here,
          .stream = level == 0 ? stream : bit_at(levels[level - 1].out, pixel),
          .carry = level < tokens.levels() && here.bit > 0 && bit_at(levels[level].carry, pixel)};
}

LevelProbe ProbedTrees::x_level(unsigned level, std::uint32_t x, const RootBits& root) const {
  return columns_.probe(level, x, root.token, root.c);
}

LevelProbe ProbedTrees::y_level(unsigned level, std::uint32_t x, const RootBits& root) const {
  const LevelProbe column = x_level(x_levels(), x, root);
  return y_levels() == 0 ? column : rows_.probe(level, x, column.token, column.stream);
}

}  // namespace csgsim::test
