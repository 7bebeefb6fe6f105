// Integer grids in the x, y plane for Clipper.
// Used by projection.cpp.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <polyclipping/clipper.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/flat/area.h"

namespace csgsim::solids {

/// Groups boxes that lines parallel to the x or y axis cannot separate. Returns the indices in each group. Outlines of
/// one group are then independent of other groups. Empty boxes are in no group.
std::vector<std::vector<std::uint32_t>> group_boxes(std::span<const facet::Box> boxes);

/// A grid of integers over a part of the x, y plane. Its step is between 2^-36 and 2^-35 of the part's size, so
/// rounding is independent of anything outside the part.
class PlaneGrid {
 public:
  /// A grid for the x and y range of a box, which must not be empty.
  explicit PlaneGrid(const facet::Box& box);

  /// Grid step in model units.
  [[nodiscard]] double step() const { return step_; }

  /// The corners of the outline, rounded to the grid. They may lie outside the box, by a small multiple of its size.
  [[nodiscard]] ClipperLib::Path to_path(const flat::Outline& outline) const;
  [[nodiscard]] flat::Outline to_outline(const ClipperLib::Path& path) const;

 private:
  glm::dvec2 origin_;
  double step_;
};

}  // namespace csgsim::solids
