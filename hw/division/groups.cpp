#include "hw/division/groups.h"

#include <algorithm>
#include <map>
#include <utility>

namespace csgsim::division {

std::vector<Group> group_squares(std::span<const isa::Region> squares, const isa::ArrayShape& picture_shape,
                                 const isa::ArrayShape& square_shape, std::uint32_t group_columns,
                                 std::uint32_t group_rows) {
  const std::uint32_t width = group_columns * square_shape.width;
  const std::uint32_t height = group_rows * square_shape.height;
  std::vector<Group> groups;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> index;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const std::uint32_t x = squares[i].x / width * width;
    const std::uint32_t y = squares[i].y / height * height;
    const auto [found, is_new] = index.emplace(std::pair(x, y), groups.size());
    if (is_new)
      groups.push_back(
          {{x, y, std::min(width, picture_shape.width - x), std::min(height, picture_shape.height - y)}, {}});
    groups[found->second].squares.push_back(i);
  }
  return groups;
}

}  // namespace csgsim::division
