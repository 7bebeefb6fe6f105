#include "hw/array/multiplier_tree.h"

#include <algorithm>

#include "hw/array/kernels.h"

namespace csgsim::array {

bool LevelTokens::any_active() const {
  return std::any_of(tokens_.begin(), tokens_.end(), [](Token token) { return token.active(); });
}

void LevelTokens::shift(Token root) {
  if (tokens_.empty()) return;
  std::shift_right(tokens_.begin(), tokens_.end(), 1);
  tokens_.front() = root;
}

void LevelTokens::clear() { std::fill(tokens_.begin(), tokens_.end(), Token{}); }

ColumnTree::ColumnTree(std::uint32_t columns)
    : columns_(columns),
      tokens_(tree_levels(columns)),
      streams_(tokens_.levels() + 1, Words((columns + word_bits - 1) / word_bits)),
      carries_(tokens_.levels(), Words((columns + word_bits - 1) / word_bits)) {}

void ColumnTree::clock_level(unsigned level, bool first, bool multiplicand) {
  const Words& in = streams_[level];
  Words& carries = carries_[level];
  Words& out = streams_[level + 1];
  const std::size_t distance = std::size_t{1} << (levels() - 1 - level);  // from a node to its right child, in columns

  const auto add = [&](std::size_t word, std::uint64_t nodes) {
    const std::uint64_t stream = in[word];
    const std::uint64_t carry = first ? 0 : carries[word];
    const std::uint64_t addend = multiplicand ? nodes : 0;
    carries[word] = (stream & carry) | (addend & (stream | carry));
    return stream ^ carry ^ addend;
  };

  if (distance >= word_bits) {
    const std::size_t step = distance / word_bits;
    for (std::size_t word = 0; word < in.size(); word += 2 * step) {
      const std::uint64_t sum = add(word, 1);
      out[word] = in[word];
      if (word + step < out.size()) out[word + step] = sum;
    }
    return;
  }
  std::uint64_t nodes = 1;  // the first leaf of each node of this level in a word
  for (std::size_t spread = 2 * distance; spread < word_bits; spread *= 2) nodes |= nodes << spread;
  for (std::size_t word = 0; word < in.size(); ++word) {
    const std::uint64_t sum = add(word, nodes);
    out[word] = (in[word] | sum << distance) & low_bits(columns_ - word * word_bits);
  }
}

void ColumnTree::clock(Token token, bool multiplicand) {
  for (unsigned level = levels(); level-- > 0;) {
    const Token here = tokens_.at(level, token);
    if (here.active()) clock_level(level, here.bit == 0, multiplicand && tokens_.multiplies(level, here));
  }
  tokens_.shift(token);
}

RowTree::RowTree(std::uint32_t rows, std::size_t row_words)
    : rows_(rows), row_words_(row_words), tokens_(tree_levels(rows)) {
  for (unsigned level = 0; level < levels(); ++level) {
    carries_.emplace_back(nodes(level) * row_words_);
    if (level > 0) streams_.emplace_back(nodes(level) * row_words_);
  }
}

/// Nodes of a level that cover at least one row: ceil(rows / 2^(levels - level)).
std::size_t RowTree::nodes(unsigned level) const {
  const std::size_t rows_of_node = std::size_t{1} << (levels() - level);
  return (rows_ + rows_of_node - 1) / rows_of_node;
}

bool RowTree::clock(Token token, std::span<const std::uint64_t> columns, bool multiplicand,
                    std::span<std::uint64_t> leaves) {
  const bool reached = tokens_.at(levels() - 1, token).active();
  for (unsigned level = levels(); level-- > 0;) {
    const Token here = tokens_.at(level, token);
    if (!here.active()) continue;
    const kernels::TreeLevel planes{.in = level == 0 ? columns.data() : streams_[level - 1].data(),
                                    .carry = carries_[level].data(),
                                    .out = level + 1 == levels() ? leaves.data() : streams_[level].data(),
                                    .nodes = nodes(level),
                                    .right_children = nodes(level + 1) - nodes(level),
                                    .row_words = row_words_};
    kernels::tree_level_step(planes, here.bit == 0, multiplicand && tokens_.multiplies(level, here));
  }
  tokens_.shift(token);
  return reached;
}

}  // namespace csgsim::array
