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
  std::vector<std::uint32_t> left;  ///< indices of the side's half-spaces that no leader of the cells above is beyond
};

bool is_corners_alone(const Rectangle& pixels) { return pixels.x1 - pixels.x0 <= 1 && pixels.y1 - pixels.y0 <= 1; }

/// Quarters of the largest power of two below the longer side, from the first corner on; fewer where they do not
/// reach. The last first.
std::vector<Rectangle> quarters_backwards(const Rectangle& pixels) {
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
  Sieve(Datapath& path, const std::vector<Tested>& side, const Rectangle& pixels)
      : path_(path), side_(side), stays_(side.size(), false), step_(std::int64_t{1} << path.header().fraction_bits) {
    whole_.pixels = pixels;
    for (std::uint32_t i = 0; i < side.size(); ++i) whole_.left.push_back(i);
  }

  /// What the rectangle's own leaders leave.
  std::vector<bool> by_leaders() {
    hold(whole_);
    std::vector<bool> left(side_.size(), false);
    for (const std::uint32_t one : whole_.left) left[one] = true;
    return left;
  }

  std::vector<bool> by_cells() {
    std::vector<Cell> cells{whole_};
    while (!cells.empty()) {
      Cell cell = std::move(cells.back());
      cells.pop_back();
      if (!hold(cell) || is_corners_alone(cell.pixels)) continue;
      for (const Rectangle& quarter : quarters_backwards(cell.pixels)) cells.push_back({quarter, cell.left});
    }
    return stays_;
  }

 private:
  /// How far in front or behind counts: fronts by their distance, backs by its opposite.
  [[nodiscard]] Values values(std::uint32_t one, const Rectangle& pixels) const {
    const Plane& plane = side_[one].plane;
    const std::int64_t sign = side_[one].side == Side::back ? -1 : 1;
    const auto at = [&](std::int32_t x, std::int32_t y) { return sign * (plane.a * x + plane.b * y + plane.c); };
    return {at(pixels.x0, pixels.y0), at(pixels.x1, pixels.y0), at(pixels.x0, pixels.y1), at(pixels.x1, pixels.y1)};
  }

  /// The values of the leaders, a corner each. They stay.
  std::array<Values, corners> find_leaders(const Cell& cell) {
    std::array<std::uint32_t, corners> leaders{};
    std::array<Values, corners> found{};
    leaders.fill(cell.left.front());
    found.fill(values(cell.left.front(), cell.pixels));
    for (const std::uint32_t one : cell.left) {
      const Values mine = values(one, cell.pixels);
      for (std::size_t corner = 0; corner < corners; ++corner) {
        if (mine[corner] <= found[corner][corner]) continue;
        leaders[corner] = one;
        found[corner] = mine;
      }
    }
    for (const std::uint32_t leader : leaders) stays_[leader] = true;
    return found;
  }

  [[nodiscard]] bool all_stay(const Cell& cell) const {
    return std::all_of(cell.left.begin(), cell.left.end(), [&](std::uint32_t one) { return stays_[one]; });
  }

  [[nodiscard]] bool is_beyond(const Values& leader, const Values& mine) const {
    return std::equal(leader.begin(), leader.end(), mine.begin(),
                      [&](std::int64_t far, std::int64_t near) { return far >= near + step_; });
  }

  /// Whether there is one in the cell of which it is not known yet.
  bool hold(Cell& cell) {
    const std::array<Values, corners> leaders = find_leaders(cell);
    path_.hold_against_leaders(cell.left.size());
    if (all_stay(cell)) return false;
    std::erase_if(cell.left, [&](std::uint32_t one) {
      const Values mine = values(one, cell.pixels);
      for (std::size_t corner = 0; corner < corners; ++corner) {
        if (mine[corner] + step_ > leaders[corner][corner]) stays_[one] = true;
      }
      return std::any_of(leaders.begin(), leaders.end(), [&](const Values& leader) { return is_beyond(leader, mine); });
    });
    return !all_stay(cell);
  }

  Datapath& path_;
  const std::vector<Tested>& side_;
  std::vector<bool> stays_;  ///< it is known that the half-space does
  std::int64_t step_;
  Cell whole_;
};

void keep(std::vector<Tested>& side, const std::vector<bool>& kept) {
  std::size_t index = 0;
  std::erase_if(side, [&](const Tested&) { return !kept[index++]; });
}

}  // namespace

void keep_by_leaders(Datapath& path, std::vector<Tested>& side, const Rectangle& pixels) {
  if (!side.empty()) keep(side, Sieve(path, side, pixels).by_leaders());
}

void keep_extremes(Datapath& path, std::vector<Tested>& side, const Rectangle& pixels) {
  if (!side.empty()) keep(side, Sieve(path, side, pixels).by_cells());
}

}  // namespace csgsim::division
