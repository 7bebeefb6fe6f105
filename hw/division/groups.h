#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::division {

/// Squares that are divided one after another, from what their group leaves.
struct Group {
  isa::Region region;                ///< holds all of them, cut off at the picture's edges
  std::vector<std::size_t> squares;  ///< indices
};

/// The squares in groups of `columns` x `rows` squares, each of a picture of that shape cut into squares of that size.
/// Groups come in the order of their first squares, and squares in a group in the order that they have.
std::vector<Group> groups_of(std::span<const isa::Region> squares, const isa::ArrayShape& picture,
                             const isa::ArrayShape& square, std::uint32_t columns, std::uint32_t rows);

}  // namespace csgsim::division
