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

/// Planes of one node with the bits in one lane and 0 in the others.
NodeBits in_lane(std::uint32_t bits, std::size_t lane, const NodeBits& shape) {
  NodeBits planes = shape;
  for (std::size_t bit = 0; bit < planes.size(); ++bit) {
    std::fill(planes[bit].begin(), planes[bit].end(), 0);
    planes[bit][lane / word_bits] = std::uint64_t{bits >> bit & 1U} << (lane % word_bits);
  }
  return planes;
}

/// Sets all lanes to the bits.
void fill_lanes(std::uint32_t bits, NodeBits& planes) {
  for (std::size_t bit = 0; bit < planes.size(); ++bit)
    planes[bit][0] = (bits >> bit & 1U) != 0 ? ~std::uint64_t{0} : 0;
}

std::size_t words_for(std::size_t lanes) { return (lanes + word_bits - 1) / word_bits; }

}  // namespace

SteppedEvaluator::SteppedEvaluator(PlaneShape shape, TreeForm form, std::span<const Place> pixels)
    : shape_(shape),
      degree_(form.degree),
      bits_(form.bits),
      pixels_(pixels.begin(), pixels.end()),
      columns_of_lanes_(lanes_of(shape, pixels)),
      columns_(shape.width, 1, form, form.degree > 1),
      rows_(shape.height, words_for(columns_of_lanes_.size()), form, false) {
  const NodeBits of_root(bits_, Words(1));
  const NodeBits of_row(bits_, Words(words_for(columns_of_lanes_.size())));
  root_.value = of_root;
  row_.value = of_row;
  if (degree_ < 2) return;
  root_.slope = of_root;
  root_.row_slope = of_root;
  row_.slope = of_row;
}

std::size_t SteppedEvaluator::plane_words() const {
  const PlaneShape built = pixels_.empty() ? shape_ : PlaneShape{static_cast<std::uint32_t>(pixels_.size()), 1};
  return built.padded_words();
}

std::size_t SteppedEvaluator::leaf_words() const { return bits_ * plane_words(); }

/// The Y trees advance first, because they read what the X tree produced one clock earlier.
Token SteppedEvaluator::clock(const RootBits& root, std::span<std::uint64_t> leaves) {
  if (!root.token.active() && !any_active()) return {};
  fill_lanes(root.c, root_.value);
  fill_lanes(root.a, root_.slope);
  fill_lanes(root.b, root_.row_slope);
  const unsigned x_levels = columns_.levels();
  const bool had_rows = rows_.levels() > 0;
  const auto enter_rows = [&] {
    const Token between = columns_.token_at(x_levels, root.token);
    if (!between.active()) return between;
    const NodeStreams& column = columns_.at(x_levels, root_);
    copy_columns_to_lanes(column.value, row_.value);
    if (degree_ > 1) copy_columns_to_lanes(column.row_slope, row_.slope);
    return between;
  };
  if (had_rows) rows_.clock(enter_rows(), row_, row_tree_wires(root));
  columns_.clock(root.token, root_, column_tree_wires(root));
  a_.shift(root.a);
  b_.shift(root.b);
  xx_.shift(root.xx);
  xy_.shift(root.xy);
  yy_.shift(root.yy);
  // The registers at the pixels follow the last level; without levels the pixels are wired to the roots.
  const Token reached = had_rows ? rows_.token_at(rows_.levels(), {}) : enter_rows();
  if (reached.active()) write_leaves(leaves);
  return reached;
}

TreeWires SteppedEvaluator::column_tree_wires(const RootBits& root) const {
  return {{a_, root.a, 0}, {xx_, root.xx, 0}, {xy_, root.xy, 0}};
}

/// The Y trees do not add the product of both coordinates.
TreeWires SteppedEvaluator::row_tree_wires(const RootBits& root) const {
  const unsigned ahead = columns_.clocks();
  return {{b_, root.b, ahead}, {yy_, root.yy, ahead}, {none_, 0, 0}};
}

/// Copies each column's bits to its lane.
void SteppedEvaluator::copy_columns_to_lanes(const NodeBits& columns, NodeBits& row) const {
  for (std::size_t bit = 0; bit < row.size(); ++bit) {
    std::fill(row[bit].begin(), row[bit].end(), 0);
    for (std::size_t lane = 0; lane < columns_of_lanes_.size(); ++lane)
      row[bit][lane / word_bits] |= (columns[bit][columns_of_lanes_[lane]] & 1U) << (lane % word_bits);
  }
}

void SteppedEvaluator::write_leaves(std::span<std::uint64_t> leaves) const {
  const NodeBits& planes = rows_.at(rows_.levels(), row_).value;
  for (std::size_t bit = 0; bit < planes.size(); ++bit) {
    const Words& bits = planes[bit];
    const std::span<std::uint64_t> plane = leaves.subspan(bit * plane_words(), plane_words());
    if (pixels_.empty()) {
      std::copy(bits.begin(), bits.end(), plane.begin());
      continue;
    }
    std::fill(plane.begin(), plane.end(), 0);
    const std::size_t node_words = row_.value.front().size();
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const std::uint64_t word = bits[pixels_[i].y * node_words + i / word_bits];
      plane[i / word_bits] |= (word >> (i % word_bits) & 1U) << (i % word_bits);
    }
  }
}

std::size_t SteppedEvaluator::find_lane(std::uint32_t x) const {
  const auto found = std::find(columns_of_lanes_.begin(), columns_of_lanes_.end(), x);
  if (found == columns_of_lanes_.end()) throw std::out_of_range("a column whose Y tree is not built");
  return static_cast<std::size_t>(std::distance(columns_of_lanes_.begin(), found));
}

LevelProbe SteppedEvaluator::x_level(unsigned level, std::uint32_t x, const RootBits& root) const {
  const NodeStreams in{in_lane(root.c, 0, root_.value), in_lane(root.a, 0, root_.slope),
                       in_lane(root.b, 0, root_.row_slope)};
  return columns_.probe(level, x, 0, root.token, in, column_tree_wires(root));
}

LevelProbe SteppedEvaluator::y_level(unsigned level, Place pixel, const RootBits& root) const {
  const LevelProbe column = x_level(columns_.levels(), pixel.x, root);
  const std::size_t lane = find_lane(pixel.x);
  const NodeStreams in{in_lane(column.stream, lane, row_.value), in_lane(column.row_slope, lane, row_.slope), {}};
  return rows_.probe(level, pixel.y, lane, column.token, in, row_tree_wires(root));
}

}  // namespace csgsim::array
