#include "hw/machines/regions.h"

#include <algorithm>
#include <bit>

namespace csgsim::machines {

namespace {

std::vector<isa::Region> lines(const Size& picture, bool interlaced) {
  std::vector<isa::Region> all;
  const std::uint32_t step = interlaced ? 2 : 1;
  for (std::uint32_t first = 0; first < step; ++first) {
    for (std::uint32_t y = first; y < picture.height; y += step) all.push_back({0, y, picture.width, 1});
  }
  return all;
}

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

/// Every other bit of the code, from the lowest on.
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

std::vector<isa::Region> squares(const Size& picture, const isa::ArrayShape& array, SquareOrder order) {
  const std::uint32_t columns = (picture.width + array.width - 1) / array.width;
  const std::uint32_t rows = (picture.height + array.height - 1) / array.height;
  const std::vector<Place> places = order == SquareOrder::morton
                                        ? by_morton_codes(columns, rows)
                                        : by_rows(columns, rows, order == SquareOrder::serpentine);
  std::vector<isa::Region> all;
  for (const Place& place : places) {
    const std::uint32_t x = place.column * array.width;
    const std::uint32_t y = place.row * array.height;
    all.push_back({x, y, std::min(array.width, picture.width - x), std::min(array.height, picture.height - y)});
  }
  return all;
}

}  // namespace

std::vector<isa::Region> regions(const Machine& machine) {
  switch (machine.kind) {
    case Kind::frame_buffer: return {{0, 0, machine.array.width, machine.array.height}};
    case Kind::scan_line: return lines(machine.picture, machine.scan_line.interlaced);
    case Kind::pixel_square: return squares(machine.picture, machine.array, machine.pixel_square.order);
  }
  return {};
}

}  // namespace csgsim::machines
