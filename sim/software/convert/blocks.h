// Block models as bintrees.
// Used by sim/app.
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

/// Limits of the resolution of a block model, in cells per side.
inline constexpr std::uint32_t min_cells = 2;
inline constexpr std::uint32_t max_cells = 1024;

/// A block model as a bintree: a cube of resolution^3 cells, halved across x, y and z in turn until each block is
/// entirely inside or outside. The code lists the tree in depth-first order (M. Tamminen and H. Samet, 1984): `(`
/// precedes the two halves of a block, the lower first; `1` is an inside block, `0` an outside block.
struct Bintree {
  std::uint32_t resolution = min_cells;  ///< a power of two
  glm::dvec3 low{0};                     ///< lowest corner of the cube, model space
  double side = 1;
  std::string code;

  /// Side of a cell in model units.
  [[nodiscard]] double cell() const { return side / resolution; }
};

/// Statistics of a bintree.
struct BlockCounts {
  std::uint64_t blocks = 0;  ///< number of leaves
  std::uint64_t full = 0;    ///< number of inside leaves
  std::uint64_t cells = 0;   ///< number of cells in inside leaves
};

/// Converts the model to blocks (thesis 5.4.1): resolution^2 rays along z through the centres of cells are classified
/// by the tree, and a block is halved unless all its rays are entirely inside or outside. The state of a cell is that
/// of its centre. A centre on a plane is treated as displaced along x, y and z by infinitesimal amounts, the largest
/// along x. The cube is centred on the model. Throws as boundary() does.
Bintree blocks(const model::Tree& tree, std::uint32_t resolution, const facet::Faceting& faceting = {},
               const Work& work = {});

BlockCounts count_blocks(const Bintree& bintree);

/// Whether each cell is inside; x varies fastest, then y.
std::vector<bool> cells_of(const Bintree& bintree);

/// The code of the bintree for these cells.
std::string code_of(const std::vector<bool>& cells, std::uint32_t resolution);

/// Text form: a line `bintree 1`, one with the resolution, one with the lowest corner and the side, and the code.
std::string text_of(const Bintree& bintree);

/// Parses the text form. If the text is invalid, throws InputError whose message begins with `name`.
Bintree read_bintree(std::string_view text, std::string_view name);

}  // namespace csgsim::software::convert
