// Classified rays for block models.
// Used by blocks.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/model/tree.h"
#include "hw/base/work.h"
#include "sim/software/convert/bodies.h"

namespace csgsim::software::convert {

/// Cells of a cube, in units.
struct CellGrid {
  glm::dvec3 low{0};
  double cell = 1;
  std::uint32_t resolution = 1;

  [[nodiscard]] double middle(int axis, std::uint32_t number) const { return low[axis] + (number + 0.5) * cell; }
};

/// Classified parallel rays along z through the centres of all columns of cells.
class RayBundle {
 public:
  RayBundle(const model::Tree& tree, const Bodies& bodies, const CellGrid& grid, const Work& work);

  /// Indices of the cells at which a ray enters or leaves the solid, alternating: it is inside from the first to just
  /// before the second.
  [[nodiscard]] std::span<const std::uint16_t> changes(std::uint32_t x, std::uint32_t y) const {
    const std::size_t ray = static_cast<std::size_t>(y) * resolution_ + x;
    return std::span(changes_).subspan(first_[ray], first_[ray + 1] - first_[ray]);
  }

 private:
  std::uint32_t resolution_;
  std::vector<std::size_t> first_;  ///< start index of each ray, and the end
  std::vector<std::uint16_t> changes_;
};

}  // namespace csgsim::software::convert
