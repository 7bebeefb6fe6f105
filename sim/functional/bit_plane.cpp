#include "sim/functional/bit_plane.h"

#include <algorithm>

#include "sim/functional/word_kernels.h"

namespace csgsim::sim {

BitPlane::BitPlane(std::uint32_t width, std::uint32_t height)
    : width_(width),
      height_(height),
      words_per_row_((width + word_bits - 1) / word_bits),
      words_(std::make_unique_for_overwrite<std::uint64_t[]>(static_cast<std::size_t>(words_per_row_) * height)) {}

void BitPlane::set_bounds(const Rect& rect) {
  bounds_ = rect.empty() ? Rect{} : rect;
  cells_ = Cells(bounds_);
  if (bounds_.empty()) solid_ = false;
}

void BitPlane::fill(const Rect& rect) {
  solid_ = true;
  set_bounds(rect);
}

void BitPlane::assign(const BitPlane& other) {
  solid_ = other.solid_;
  set_bounds(other.bounds_);
  if (solid_) return;
  for (std::uint32_t row = cells_.row; row < cells_.row + cells_.rows; ++row) {
    const std::size_t first = offset(row, cells_.column);
    std::copy_n(&other.words_[first], cells_.columns, &words_[first]);
  }
}

void BitPlane::materialise() {
  if (!solid_) return;
  for (std::uint32_t row = cells_.row; row < cells_.row + cells_.rows; ++row)
    for (std::uint32_t column = cells_.column; column < cells_.column + cells_.columns; ++column)
      words_[offset(row, column)] = columns_mask(bounds_, column);
  solid_ = false;
}

void BitPlane::cover(const Rect& rect) {
  materialise();
  const Rect wider = hull(bounds_, rect);
  const Cells cells(wider);
  for (std::uint32_t row = cells.row; row < cells.row + cells.rows; ++row)
    for (std::uint32_t column = cells.column; column < cells.column + cells.columns; ++column)
      if (!cells_.holds(row, column)) words_[offset(row, column)] = 0;
  set_bounds(wider);
}

void BitPlane::narrow(const Rect& rect) { set_bounds(rect); }

WordBlock BitPlane::block(const Rect& rect) {
  const Cells cells(rect);
  return {&words_[offset(cells.row, cells.column)], words_per_row_, cells.columns, cells.rows};
}

std::uint64_t settle(BitPlane& plane) {
  if (plane.solid() || plane.bounds().empty()) return plane.bounds().area();
  const Rect old = plane.bounds();
  const Tally counted = tally(plane.block());
  const std::uint32_t left = old.x0 / word_bits * word_bits;
  const Rect& ones = counted.bounds;
  plane.narrow(ones.empty() ? Rect{} : Rect{left + ones.x0, old.y0 + ones.y0, left + ones.x1, old.y0 + ones.y1});
  return counted.ones;
}

}  // namespace csgsim::sim
