#include "host/emit/cell_tests.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace csgsim::emit {

namespace {

using view::PixelRect;
using Indices = std::vector<std::size_t>;
using Pixel = std::pair<std::int32_t, std::int32_t>;

class Counting {
 public:
  Counting(std::span<const view::FixedLinear> planes, std::int64_t sign, std::int64_t step)
      : planes_(planes), sign_(sign), step_(step) {}

  /// The cell's tests and, with `quarters`, those of its quarters.
  void count(const PixelRect& cell, Indices open, bool quarters) {
    const std::vector<Pixel> corners{{cell.x0, cell.y0}, {cell.x1, cell.y0}, {cell.x0, cell.y1}, {cell.x1, cell.y1}};
    std::set<std::size_t> leaders;
    for (const Pixel& corner : corners) leaders.insert(leader_at(corner, open));
    settled_.insert(leaders.begin(), leaders.end());
    if (is_settled(open)) return;
    tests += open.size();
    const auto is_near = [&](std::size_t one, const Pixel& corner) {
      return value(one, corner) + step_ > value(leader_at(corner, open), corner);
    };
    const auto is_beyond = [&](std::size_t far, std::size_t near) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Pixel& corner) { return value(near, corner) + step_ <= value(far, corner); });
    };
    Indices left;
    for (const std::size_t one : open) {
      if (std::any_of(corners.begin(), corners.end(), [&](const Pixel& corner) { return is_near(one, corner); }))
        settled_.insert(one);
      if (std::none_of(leaders.begin(), leaders.end(), [&](std::size_t leader) { return is_beyond(leader, one); }))
        left.push_back(one);
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

  [[nodiscard]] std::size_t leader_at(const Pixel& corner, const Indices& open) const {
    return *std::max_element(open.begin(), open.end(),
                             [&](std::size_t a, std::size_t b) { return value(a, corner) < value(b, corner); });
  }

  [[nodiscard]] bool is_settled(const Indices& open) const {
    return std::all_of(open.begin(), open.end(), [&](std::size_t one) { return settled_.contains(one); });
  }

  std::span<const view::FixedLinear> planes_;
  std::int64_t sign_;
  std::int64_t step_;
  std::set<std::size_t> settled_;
};

}  // namespace

std::uint64_t count_cell_tests(std::span<const view::FixedLinear> planes, std::int64_t sign, std::int64_t step,
                               const PixelRect& pixels, bool quarters) {
  if (planes.empty()) return 0;
  Indices all;
  for (std::size_t i = 0; i < planes.size(); ++i) all.push_back(i);
  Counting counting(planes, sign, step);
  counting.count(pixels, std::move(all), quarters);
  return counting.tests;
}

}  // namespace csgsim::emit
