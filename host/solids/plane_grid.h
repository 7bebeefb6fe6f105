#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <polyclipping/clipper.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/flat/area.h"

namespace csgsim::solids {

/// Sorts boxes by their x and y into groups that lines along the x and y axes keep apart. Returns their numbers. What
/// is in one group has no part in the outlines of another. Empty boxes are in none.
std::vector<std::vector<std::uint32_t>> groups_of(std::span<const facet::Box> boxes);

/// A grid of whole numbers over a part of the x, y plane: its step is 2^-36 of the part's size, or up to twice as much,
/// so that rounding depends on nothing outside of the part.
class PlaneGrid {
 public:
  /// Over the x and y of a box that is not empty.
  explicit PlaneGrid(const facet::Box& box);

  /// Model units between two numbers of the grid.
  [[nodiscard]] double step() const { return step_; }

  /// The corners, rounded. They may be outside of the box, by some times its size.
  [[nodiscard]] ClipperLib::Path path_of(const flat::Outline& outline) const;
  [[nodiscard]] flat::Outline outline_of(const ClipperLib::Path& path) const;

 private:
  glm::dvec2 origin_;
  double step_;
};

}  // namespace csgsim::solids
