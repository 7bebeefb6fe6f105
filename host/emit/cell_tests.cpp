#include "host/emit/cell_tests.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace csgsim::emit {

namespace {

using view::PixelRect;
using Indices = std::vector<std::size_t>;
using Pixel = std::pair<std::int32_t, std::int32_t>;

/// The corners of a cell and, for each corner, the first of the open half-spaces with the greatest value there.
struct CellCorners {
  std::array<Pixel, 4> pixels;
  std::array<std::size_t, 4> leaders{};
};

class Counting {
 public:
  Counting(std::span<const view::FixedLinear> planes, std::int64_t sign, std::int64_t step)
      : planes_(planes), sign_(sign), step_(step), settled_(planes.size(), false) {}

  /// Counts the tests of the cell and, with `quarters`, those of its quarters.
  void count(const PixelRect& cell, const Indices& open, bool quarters) {
    const CellCorners corners = find_corners(cell, open);
    for (const std::size_t leader : corners.leaders) settled_[leader] = true;
    tests += open.size();
    if (is_settled(open)) return;
    Indices left;
    for (const std::size_t one : open) {
      if (is_near(one, corners)) settled_[one] = true;
      if (!is_behind_a_leader(one, corners)) left.push_back(one);
    }
    const std::int32_t longer = std::max(cell.x1 - cell.x0, cell.y1 - cell.y0) + 1;
    if (!quarters || longer <= 2 || is_settled(left)) return;
    std::int32_t half = 1;
    while (2 * half < longer) half *= 2;
    for (std::int32_t y = cell.y0; y <= cell.y1; y += half) {
      for (std::int32_t x = cell.x0; x <= cell.x1; x += half)
        count({x, y, std::min(x + half - 1, cell.x1), std::min(y + half - 1, cell.y1)}, left, true);
    }
  }

  std::uint64_t tests = 0;

 private:
  [[nodiscard]] std::int64_t value(std::size_t one, const Pixel& pixel) const {
    return sign_ * (planes_[one].a * pixel.first + planes_[one].b * pixel.second + planes_[one].c);
  }

  [[nodiscard]] CellCorners find_corners(const PixelRect& cell, const Indices& open) const {
    CellCorners corners{{{{cell.x0, cell.y0}, {cell.x1, cell.y0}, {cell.x0, cell.y1}, {cell.x1, cell.y1}}}};
    std::transform(corners.pixels.begin(), corners.pixels.end(), corners.leaders.begin(), [&](const Pixel& corner) {
      return *std::max_element(open.begin(), open.end(),
                               [&](std::size_t a, std::size_t b) { return value(a, corner) < value(b, corner); });
    });
    return corners;
  }

  /// Whether the half-space is within a depth step of the leader at some corner.
  [[nodiscard]] bool is_near(std::size_t one, const CellCorners& corners) const {
    for (std::size_t i = 0; i < corners.pixels.size(); ++i) {
      const Pixel& corner = corners.pixels[i];
      if (value(one, corner) + step_ > value(corners.leaders[i], corner)) return true;
    }
    return false;
  }

  /// Whether one of the leaders is ahead of the half-space by a depth step or more at every corner.
  [[nodiscard]] bool is_behind_a_leader(std::size_t one, const CellCorners& corners) const {
    return std::any_of(corners.leaders.begin(), corners.leaders.end(), [&](std::size_t leader) {
      return std::all_of(corners.pixels.begin(), corners.pixels.end(),
                         [&](const Pixel& corner) { return value(one, corner) + step_ <= value(leader, corner); });
    });
  }

  [[nodiscard]] bool is_settled(const Indices& open) const {
    return std::all_of(open.begin(), open.end(), [&](std::size_t one) { return settled_[one]; });
  }

  std::span<const view::FixedLinear> planes_;
  std::int64_t sign_;
  std::int64_t step_;
  std::vector<bool> settled_;  ///< by half-space: known to be kept
};

}  // namespace

std::uint64_t count_cell_tests(std::span<const view::FixedLinear> planes, std::int64_t sign, std::int64_t step,
                               const PixelRect& pixels, bool quarters) {
  if (planes.empty()) return 0;
  Indices all;
  for (std::size_t i = 0; i < planes.size(); ++i) all.push_back(i);
  Counting counting(planes, sign, step);
  counting.count(pixels, all, quarters);
  return counting.tests;
}

}  // namespace csgsim::emit
