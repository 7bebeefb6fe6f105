#include "hw/multi_processor/regions.h"

#include <algorithm>

#include "hw/base/quotient.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"

namespace csgsim::multi_processor {

namespace {

/// The positions from `first` on that are congruent to `rest` modulo `step`.
struct Places {
  std::uint32_t first = 0;  ///< relative to the beginning
  std::uint32_t count = 0;
};

Places places_of(std::uint32_t begin, std::uint32_t length, std::uint32_t step, std::uint32_t rest) {
  const std::uint32_t first = (rest + step - begin % step) % step;
  return {first, first < length ? quotient_up(length - first, step) : 0};
}

std::uint32_t part_length(std::uint32_t length, std::uint32_t parts) { return quotient_up(length, parts); }

}  // namespace

std::vector<isa::Region> divide_region(const isa::Region& region, std::uint32_t columns, std::uint32_t rows) {
  const std::uint32_t width = part_length(region.width, columns);
  const std::uint32_t height = part_length(region.height, rows);
  std::vector<isa::Region> parts;
  for (std::uint32_t y = 0; y < region.height; y += height) {
    for (std::uint32_t x = 0; x < region.width; x += width) {
      parts.push_back(
          {region.x + x, region.y + y, std::min(width, region.width - x), std::min(height, region.height - y)});
    }
  }
  return parts;
}

std::vector<isa::Region> picture_segments(machines::Size picture, std::uint32_t levels) {
  return divide_region({0, 0, picture.width, picture.height}, 1U << (levels + 1) / 2, 1U << levels / 2);
}

std::vector<isa::Region> Kind::regions(const machines::Machine& machine) const {
  std::vector<isa::Region> all;
  for (const isa::Region& segment :
       picture_segments(machine.picture, machines::kind_figures<Figures>(machine).levels)) {
    const std::vector<isa::Region> parts = divide_region(segment, machine.array.width, machine.array.height);
    all.insert(all.end(), parts.begin(), parts.end());
  }
  return all;
}

NodePixels pixels_of_node(const isa::Region& region, const isa::ArrayShape& array, std::uint32_t row,
                          std::uint32_t column) {
  const Places across = places_of(region.x, region.width, array.width, column);
  const Places down = places_of(region.y, region.height, array.height, row);
  if (across.count == 0 || down.count == 0) return {};
  return {across.first, down.first, across.count, down.count};
}

}  // namespace csgsim::multi_processor
