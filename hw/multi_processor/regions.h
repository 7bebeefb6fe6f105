#pragma once

#include <cstdint>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::multi_processor {

/// Divides the region into at most `columns` x `rows` equal parts, clipped at the right and bottom edges, row by row. A
/// region with too few pixels has fewer parts.
std::vector<isa::Region> divide_region(const isa::Region& region, std::uint32_t columns, std::uint32_t rows);

/// The segments of a picture, row by row, after `levels` halvings, alternately of columns (first) and rows.
std::vector<isa::Region> picture_segments(machines::Size picture, std::uint32_t levels);

/// The pixels of a region that one node holds, relative to the region's top left; all 0 if it holds none.
struct NodePixels {
  std::uint32_t first_x = 0;
  std::uint32_t first_y = 0;
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;

  [[nodiscard]] std::uint64_t count() const { return std::uint64_t{columns} * rows; }
};

/// The pixels of `region` that node (row, column) of the array holds: those of the picture with y mod height = row and
/// x mod width = column.
NodePixels pixels_of_node(const isa::Region& region, const isa::ArrayShape& array, std::uint32_t row,
                          std::uint32_t column);

}  // namespace csgsim::multi_processor
