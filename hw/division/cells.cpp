#include "hw/division/cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

namespace csgsim::division {

namespace {

constexpr std::size_t corners = 4;
using Values = std::array<std::int64_t, corners>;

struct Cell {
  Rectangle pixels;
  std::vector<std::uint32_t> candidates;  ///< indices of the side's half-spaces that no leader of the enclosing cells
                                          ///< is beyond
};

bool has_only_corners(const Rectangle& pixels) { return pixels.x1 - pixels.x0 <= 1 && pixels.y1 - pixels.y0 <= 1; }

/// Quarters whose side is the largest power of two below the rectangle's longer side, in reverse order; fewer than four
/// if the rectangle is narrow.
std::vector<Rectangle> reversed_quarters(const Rectangle& pixels) {
  const auto longer = static_cast<std::uint32_t>(std::max(pixels.x1 - pixels.x0, pixels.y1 - pixels.y0) + 1);
  const auto size = static_cast<std::int32_t>(std::bit_ceil(longer) / 2);
  std::vector<Rectangle> quarters;
  for (const std::int32_t y : {pixels.y0 + size, pixels.y0}) {
    for (const std::int32_t x : {pixels.x0 + size, pixels.x0}) {
      const Rectangle quarter = overlap(pixels, {x, y, x + size - 1, y + size - 1});
      if (!quarter.empty()) quarters.push_back(quarter);
    }
  }
  return quarters;
}

class Sieve {
 public:
  Sieve(Datapath& path, const std::vector<TestedHalfspace>& side, const Rectangle& pixels)
      : path_(path), side_(side), kept_(side.size(), false), step_(std::int64_t{1} << path.header().fraction_bits) {
    whole_.pixels = pixels;
    for (std::uint32_t i = 0; i < side.size(); ++i) whole_.candidates.push_back(i);
  }

  /// Half-spaces that survive the rectangle's own leaders.
  std::vector<bool> filter_by_leaders() {
    test_cell(whole_);
    std::vector<bool> candidates(side_.size(), false);
    for (const std::uint32_t one : whole_.candidates) candidates[one] = true;
    return candidates;
  }

  std::vector<bool> filter_by_cells() {
    std::vector<Cell> cells{whole_};
    while (!cells.empty()) {
      Cell cell = std::move(cells.back());
      cells.pop_back();
      if (!test_cell(cell) || has_only_corners(cell.pixels)) continue;
      for (const Rectangle& quarter : reversed_quarters(cell.pixels)) cells.push_back({quarter, cell.candidates});
    }
    return kept_;
  }

 private:
  /// Values by which half-spaces are compared at the corners: the distance for fronts, its negative for backs.
  [[nodiscard]] Values values(std::uint32_t one, const Rectangle& pixels) const {
    const Plane& plane = side_[one].plane;
    const std::int64_t sign = side_[one].side == Side::back ? -1 : 1;
    const auto at = [&](std::int32_t x, std::int32_t y) { return sign * (plane.a * x + plane.b * y + plane.c); };
    return {at(pixels.x0, pixels.y0), at(pixels.x1, pixels.y0), at(pixels.x0, pixels.y1), at(pixels.x1, pixels.y1)};
  }

  /// Values of the leaders, one per corner. Marks the leaders as kept.
  std::array<Values, corners> find_leaders(const Cell& cell) {
    std::array<std::uint32_t, corners> leaders{};
    std::array<Values, corners> found{};
    leaders.fill(cell.candidates.front());
    found.fill(values(cell.candidates.front(), cell.pixels));
    for (const std::uint32_t one : cell.candidates) {
      const Values own_values = values(one, cell.pixels);
      for (std::size_t corner = 0; corner < corners; ++corner) {
        if (own_values[corner] <= found[corner][corner]) continue;
        leaders[corner] = one;
        found[corner] = own_values;
      }
    }
    for (const std::uint32_t leader : leaders) kept_[leader] = true;
    return found;
  }

  [[nodiscard]] bool all_kept(const Cell& cell) const {
    return std::all_of(cell.candidates.begin(), cell.candidates.end(), [&](std::uint32_t one) { return kept_[one]; });
  }

  [[nodiscard]] bool is_beyond(const Values& leader, const Values& own_values) const {
    return std::equal(leader.begin(), leader.end(), own_values.begin(),
                      [&](std::int64_t far, std::int64_t near) { return far >= near + step_; });
  }

  /// Tests the cell. Returns whether some half-space in it is undecided.
  bool test_cell(Cell& cell) {
    const std::array<Values, corners> leaders = find_leaders(cell);
    path_.compare_with_leaders(cell.candidates.size());
    if (all_kept(cell)) return false;
    std::erase_if(cell.candidates, [&](std::uint32_t one) {
      const Values own_values = values(one, cell.pixels);
      for (std::size_t corner = 0; corner < corners; ++corner) {
        if (own_values[corner] + step_ > leaders[corner][corner]) kept_[one] = true;
      }
      return std::any_of(leaders.begin(), leaders.end(),
                         [&](const Values& leader) { return is_beyond(leader, own_values); });
    });
    return !all_kept(cell);
  }

  Datapath& path_;
  const std::vector<TestedHalfspace>& side_;
  std::vector<bool> kept_;  ///< half-spaces decided to be kept
  std::int64_t step_;
  Cell whole_;
};

void keep(std::vector<TestedHalfspace>& side, const std::vector<bool>& kept) {
  std::size_t index = 0;
  std::erase_if(side, [&](const TestedHalfspace&) { return !kept[index++]; });
}

}  // namespace

void remove_behind_leaders(Datapath& path, std::vector<TestedHalfspace>& halfspaces, const Rectangle& pixels) {
  if (!halfspaces.empty()) keep(halfspaces, Sieve(path, halfspaces, pixels).filter_by_leaders());
}

void remove_hidden_halfspaces(Datapath& path, std::vector<TestedHalfspace>& halfspaces, const Rectangle& pixels) {
  if (!halfspaces.empty()) keep(halfspaces, Sieve(path, halfspaces, pixels).filter_by_cells());
}

}  // namespace csgsim::division
