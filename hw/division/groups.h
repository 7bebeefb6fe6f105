#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::division {

/// Squares that are divided one after another from the survivors of their group.
struct Group {
  isa::Region region;                ///< bounding region of all squares, clipped at the picture's edges
  std::vector<std::size_t> squares;  ///< indices of the squares
};

/// Divides the squares into groups of `group_columns` x `group_rows` squares. Groups are ordered by their first
/// squares; the squares of a group keep their order.
std::vector<Group> group_squares(std::span<const isa::Region> squares, const isa::ArrayShape& picture_shape,
                                 const isa::ArrayShape& square_shape, std::uint32_t group_columns,
                                 std::uint32_t group_rows);

}  // namespace csgsim::division
