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

/// Divides the squares into groups of `columns` x `rows` squares. `picture` and `square` are the shapes of the picture
/// and of a square. Groups are ordered by their first squares; the squares of a group keep their order.
std::vector<Group> groups_of(std::span<const isa::Region> squares, const isa::ArrayShape& picture,
                             const isa::ArrayShape& square, std::uint32_t columns, std::uint32_t rows);

}  // namespace csgsim::division
