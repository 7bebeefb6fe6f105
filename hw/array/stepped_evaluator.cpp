#include "hw/array/stepped_evaluator.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>

namespace csgsim::array {

namespace {

std::vector<std::uint32_t> lanes_of(PlaneShape shape, std::span<const Place> pixels) {
  std::vector<std::uint32_t> columns;
  for (const Place& pixel : pixels) columns.push_back(pixel.x);
  if (!pixels.empty()) return columns;
  columns.resize(shape.width);
  std::iota(columns.begin(), columns.end(), 0U);
  return columns;
}

std::size_t words_for(std::size_t lanes) { return (lanes + word_bits - 1) / word_bits; }

}  // namespace

SteppedEvaluator::SteppedEvaluator(PlaneShape shape, unsigned degree, std::span<const Place> pixels)
    : shape_(shape),
      degree_(degree),
      pixels_(pixels.begin(), pixels.end()),
      columns_of_lanes_(lanes_of(shape, pixels)),
      columns_(shape.width, 1, degree, degree > 1),
      rows_(shape.height, words_for(columns_of_lanes_.size()), degree, false) {
  root_.value.resize(1);
  row_.value.resize(words_for(columns_of_lanes_.size()));
  if (degree < 2) return;
  root_.slope.resize(1);
  root_.row_slope.resize(1);
  row_.slope.resize(row_.value.size());
}

std::size_t SteppedEvaluator::leaf_words() const {
  const PlaneShape built = pixels_.empty() ? shape_ : PlaneShape{static_cast<std::uint32_t>(pixels_.size()), 1};
  return built.padded_words();
}

/// The Y trees first: they take what the X tree has left the clock before.
Token SteppedEvaluator::clock(const RootBits& root, std::span<std::uint64_t> leaves) {
  if (!root.token.active() && !any_active()) return {};
  root_.value[0] = root.c ? ~std::uint64_t{0} : 0;
  if (degree_ > 1) {
    root_.slope[0] = root.a ? ~std::uint64_t{0} : 0;
    root_.row_slope[0] = root.b ? ~std::uint64_t{0} : 0;
  }
  const unsigned x_levels = columns_.levels();
  const bool had_rows = rows_.levels() > 0;
  const Wire none;
  const auto enter_rows = [&] {
    const Token between = columns_.token_at(x_levels, root.token);
    if (!between.active()) return between;
    const NodeStreams& column = columns_.at(x_levels, root_);
    gather(column.value, row_.value);
    if (degree_ > 1) gather(column.row_slope, row_.slope);
    return between;
  };
  const TreeWires to_rows{{b_, root.b, x_levels}, {yy_, root.yy, x_levels}, {none, false, 0}};
  const TreeWires to_columns{{a_, root.a, 0}, {xx_, root.xx, 0}, {xy_, root.xy, 0}};
  if (had_rows) rows_.clock(enter_rows(), row_, to_rows);
  columns_.clock(root.token, root_, to_columns);
  a_.shift(root.a);
  b_.shift(root.b);
  xx_.shift(root.xx);
  xy_.shift(root.xy);
  yy_.shift(root.yy);
  // Behind the last level are the registers at the pixels; without one the roots' wires.
  const Token reached = had_rows ? rows_.token_at(rows_.levels(), {}) : enter_rows();
  if (reached.active()) put_leaves(leaves);
  return reached;
}

/// A column's bit to each lane.
void SteppedEvaluator::gather(const Words& column_bits, Words& row) const {
  std::fill(row.begin(), row.end(), 0);
  for (std::size_t lane = 0; lane < columns_of_lanes_.size(); ++lane)
    row[lane / word_bits] |= (column_bits[columns_of_lanes_[lane]] & 1U) << (lane % word_bits);
}

void SteppedEvaluator::put_leaves(std::span<std::uint64_t> leaves) const {
  const Words& bits = rows_.at(rows_.levels(), row_).value;
  if (pixels_.empty()) {
    std::copy(bits.begin(), bits.end(), leaves.begin());
    return;
  }
  std::fill(leaves.begin(), leaves.end(), 0);
  const std::size_t node_words = row_.value.size();
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const std::uint64_t word = bits[pixels_[i].y * node_words + i / word_bits];
    leaves[i / word_bits] |= (word >> (i % word_bits) & 1U) << (i % word_bits);
  }
}

std::size_t SteppedEvaluator::lane_of(std::uint32_t x) const {
  const auto found = std::find(columns_of_lanes_.begin(), columns_of_lanes_.end(), x);
  if (found == columns_of_lanes_.end()) throw std::out_of_range("a column whose Y tree is not built");
  return static_cast<std::size_t>(std::distance(columns_of_lanes_.begin(), found));
}

LevelProbe SteppedEvaluator::x_level(unsigned level, std::uint32_t x, const RootBits& root) const {
  NodeStreams in;
  in.value.assign(1, root.c ? 1 : 0);
  if (degree_ > 1) {
    in.slope.assign(1, root.a ? 1 : 0);
    in.row_slope.assign(1, root.b ? 1 : 0);
  }
  return columns_.probe(level, x, 0, root.token, in);
}

LevelProbe SteppedEvaluator::y_level(unsigned level, Place pixel, const RootBits& root) const {
  const LevelProbe column = x_level(columns_.levels(), pixel.x, root);
  const std::size_t lane = lane_of(pixel.x);
  NodeStreams in;
  in.value.assign(row_.value.size(), 0);
  in.value[lane / word_bits] = std::uint64_t{column.stream} << (lane % word_bits);
  if (degree_ > 1) {
    in.slope.assign(row_.slope.size(), 0);
    in.slope[lane / word_bits] = std::uint64_t{column.row_slope} << (lane % word_bits);
  }
  return rows_.probe(level, pixel.y, lane, column.token, in);
}

}  // namespace csgsim::array
