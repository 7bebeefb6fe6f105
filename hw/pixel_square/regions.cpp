#include <algorithm>
#include <bit>

#include "hw/base/quotient.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"

namespace csgsim::pixel_square {

namespace {

/// Column and row of a square.
struct Place {
  std::uint32_t column = 0;
  std::uint32_t row = 0;
};

std::vector<Place> by_rows(std::uint32_t columns, std::uint32_t rows, bool serpentine) {
  std::vector<Place> places;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const bool backwards = serpentine && row % 2 == 1;
    for (std::uint32_t i = 0; i < columns; ++i) places.push_back({backwards ? columns - 1 - i : i, row});
  }
  return places;
}

/// Extracts the even-numbered bits of the code.
std::uint32_t even_bits(std::uint64_t code) {
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 32; ++i) bits |= static_cast<std::uint32_t>(code >> (2 * i) & 1U) << i;
  return bits;
}

std::vector<Place> by_morton_codes(std::uint32_t columns, std::uint32_t rows) {
  const std::uint64_t side = std::bit_ceil(std::max(columns, rows));
  std::vector<Place> places;
  for (std::uint64_t code = 0; code < side * side; ++code) {
    const Place place{even_bits(code), even_bits(code >> 1U)};
    if (place.column < columns && place.row < rows) places.push_back(place);
  }
  return places;
}

/// Squares of a grid, in drawing order.
std::vector<Place> places(std::uint32_t columns, std::uint32_t rows, SquareOrder order) {
  return order == SquareOrder::morton ? by_morton_codes(columns, rows)
                                      : by_rows(columns, rows, order == SquareOrder::serpentine);
}

/// Squares in groups of `side` x `side`; groups, and squares within a group, are in the same order.
std::vector<Place> places_in_groups(std::uint32_t columns, std::uint32_t rows, SquareOrder order, std::uint32_t side) {
  std::vector<Place> all;
  for (const Place& group : places(quotient_up(columns, side), quotient_up(rows, side), order)) {
    const std::uint32_t column = group.column * side;
    const std::uint32_t row = group.row * side;
    for (const Place& place : places(std::min(side, columns - column), std::min(side, rows - row), order))
      all.push_back({column + place.column, row + place.row});
  }
  return all;
}

}  // namespace

std::vector<isa::Region> Kind::regions(const machines::Machine& machine) const {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const machines::Size& picture = machine.picture;
  const isa::ArrayShape& array = machine.array;
  const std::uint32_t columns = quotient_up(picture.width, array.width);
  const std::uint32_t rows = quotient_up(picture.height, array.height);
  const bool in_groups = figures.divider == DividerKind::corners && figures.levels == 2;
  std::vector<isa::Region> all;
  for (const Place& place : places_in_groups(columns, rows, figures.order, in_groups ? figures.group_side : 1)) {
    const std::uint32_t x = place.column * array.width;
    const std::uint32_t y = place.row * array.height;
    all.push_back({x, y, std::min(array.width, picture.width - x), std::min(array.height, picture.height - y)});
  }
  return all;
}

}  // namespace csgsim::pixel_square
