#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::software::convert {

/// Of a block model, along each side.
inline constexpr std::uint32_t fewest_cells = 2;
inline constexpr std::uint32_t most_cells = 1024;

/// A block model as a bintree: a cube of resolution^3 cells that is halved across x, y and z in turn until a block is
/// all in or all out; what it comes to in depth-first order (M. Tamminen and H. Samet, 1984): `(` before the two halves
/// of a block, the lower first; `1` for one that is in, `0` for one that is out.
struct Bintree {
  std::uint32_t resolution = fewest_cells;  ///< a power of two
  glm::dvec3 low{0};                        ///< corner of the cube, model space
  double side = 1;
  std::string code;

  /// Model units.
  [[nodiscard]] double cell() const { return side / resolution; }
};

/// What is told of a bintree.
struct BlockCounts {
  std::uint64_t blocks = 0;  ///< that are in or out
  std::uint64_t full = 0;    ///< that are in
  std::uint64_t cells = 0;   ///< of these
};

/// The model's blocks (thesis 5.4.1): resolution^2 rays along z through the middles of cells are classified by the
/// tree, and a block whose rays are not all in or all out is halved; a cell is what its middle is. A middle on a plane
/// counts as moved along x, y and z by as good as nothing, x by most. The cube has the model's middle. Throws as
/// boundary() does.
Bintree blocks(const model::Tree& tree, std::uint32_t resolution, const facet::Faceting& faceting = {},
               const Work& work = {});

BlockCounts count_blocks(const Bintree& bintree);

/// Of each cell whether it is in; x varies fastest, then y.
std::vector<bool> cells_of(const Bintree& bintree);

/// The bintree of such cells.
std::string code_of(const std::vector<bool>& cells, std::uint32_t resolution);

/// As text: a line with `bintree 1`, one with the resolution, one with the low corner and the side, and the code.
std::string text_of(const Bintree& bintree);

/// Throws InputError, with the name, for what is no such text.
Bintree read_bintree(std::string_view text, std::string_view name);

}  // namespace csgsim::software::convert
