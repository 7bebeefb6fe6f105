#include "hw/array/linear_evaluator.h"

#include <algorithm>

namespace csgsim::array {

namespace {

unsigned less_one(unsigned levels) { return levels == 0 ? 0 : levels - 1; }

}  // namespace

LinearEvaluator::LinearEvaluator(PlaneShape shape)
    : columns_(shape.width),
      rows_(shape.height, shape.row_words()),
      a_(less_one(columns_.levels())),
      b_(less_one(columns_.levels() + rows_.levels())) {}

bool LinearEvaluator::clock(const RootBits& root, std::span<std::uint64_t> leaves) {
  if (!root.token.active() && !any_active()) return false;
  const bool a = a_.out(root.a);
  const bool b = b_.out(root.b);
  a_.shift(root.a);
  b_.shift(root.b);
  columns_.set_root(root.c);
  if (rows_.levels() == 0) return clock_single_row(root, a, leaves);
  const bool reached = rows_.clock(columns_.leaf_token(root.token), columns_.leaves(), b, leaves);
  columns_.clock(root.token, a);
  return reached;
}

/// Without a Y tree the registers at the pixels are the X tree's last ones.
bool LinearEvaluator::clock_single_row(const RootBits& root, bool multiplicand, std::span<std::uint64_t> leaves) {
  columns_.clock(root.token, multiplicand);
  if (!columns_.leaf_token(root.token).active()) return false;
  const std::span<const std::uint64_t> row = columns_.leaves();
  std::copy(row.begin(), row.end(), leaves.begin());
  return true;
}

void LinearEvaluator::clear() {
  columns_.clear();
  rows_.clear();
}

}  // namespace csgsim::array
