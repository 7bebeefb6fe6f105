// Regular lattices of cells, and traversal from query point to query point.
// Used by excell.h and octree.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "host/facet/geometry.h"
#include "sim/software/space/clip_ray.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// A box divided into 2^bits cells along each axis.
struct Lattice {
  facet::Box box;
  unsigned bits = 0;

  [[nodiscard]] std::uint32_t size() const { return std::uint32_t{1} << bits; }
  /// Coordinate of the wall after `cells` cells.
  [[nodiscard]] double wall(int axis, std::uint32_t cells) const {
    if (cells == size()) return box.high[axis];
    return box.low[axis] + (box.high[axis] - box.low[axis]) * std::ldexp(cells, -static_cast<int>(bits));
  }
  /// The cell that contains a coordinate; coordinates outside are clamped.
  [[nodiscard]] std::uint32_t cell(int axis, double coordinate) const {
    const double cells = (coordinate - box.low[axis]) / (box.high[axis] - box.low[axis]) * size();
    return static_cast<std::uint32_t>(std::clamp(std::floor(cells), 0.0, static_cast<double>(size() - 1)));
  }
  /// The block of 2^(bits - n) cells along each axis, n = `depths`, that contains a cell.
  [[nodiscard]] facet::Box block(const glm::uvec3& cell, const glm::uvec3& depths) const {
    facet::Box box_of_it;
    for (int axis = 0; axis < 3; ++axis) {
      const unsigned shift = bits - depths[axis];
      const std::uint32_t first = cell[axis] >> shift << shift;
      box_of_it.low[axis] = wall(axis, first);
      box_of_it.high[axis] = wall(axis, first + (std::uint32_t{1} << shift));
    }
    return box_of_it;
  }
};

/// Result of a query: the facets of the block that contains a cell.
struct Located {
  std::span<const std::uint32_t> facets;
  glm::uvec3 depths{0};  ///< number of halvings along each axis
};

/// Visits blocks from query point to query point (thesis algorithm 5.3): `locate(cell, count)` returns the block of a
/// cell; the ray leaves it through the nearest wall, and the next query point is behind that wall. The cell next to the
/// wall is determined by its number, so that rounding can neither stop the ray nor skip cells.
template <class Count, class Locate>
class PointWalk {
 public:
  PointWalk(const Lattice& lattice, const SpaceRay& ray, const Locate& locate, Count& count)
      : lattice_(lattice), ray_(ray), locate_(locate), count_(count), inverse_(inverse_direction(ray, count)) {}

  void walk_cells(CellVisitor& visitor) {
    const RayPart part = clip_to_box(ray_, inverse_, lattice_.box, count_);
    if (part.empty()) return;
    end_ = part.end;
    t_ = part.begin;
    const glm::dvec3 point = ray_.at(t_);
    for (int axis = 0; axis < 3; ++axis) at_[axis] = lattice_.cell(axis, point[axis]);
    count_products(count_, 2 * 3);
    for (;;) {
      const Located found = locate_(at_, count_);
      const int axis = find_exit(found.depths);
      count_(Operation::call);
      count_(Operation::come_back);
      if (!visitor.visit({t_, exit_, exit_, found.facets}) || axis < 0 || !step(axis, found.depths)) return;
      t_ = exit_;
    }
  }

 private:
  [[nodiscard]] std::uint32_t first_of(int axis, const glm::uvec3& depths) const {
    const unsigned shift = lattice_.bits - depths[axis];
    return at_[axis] >> shift << shift;
  }
  [[nodiscard]] std::uint32_t end_of(int axis, const glm::uvec3& depths) const {
    return first_of(axis, depths) + (std::uint32_t{1} << (lattice_.bits - depths[axis]));
  }

  /// The axis of the wall through which the ray leaves; -1 if the ray ends before.
  int find_exit(const glm::uvec3& depths) {
    int exit_axis = -1;
    exit_ = end_;
    for (int axis = 0; axis < 3; ++axis) {
      count_(Operation::load_long);
      count_(Operation::branch);
      if (ray_.direction[axis] == 0) continue;
      const double wall = lattice_.wall(axis, ray_.direction[axis] > 0 ? end_of(axis, depths) : first_of(axis, depths));
      const double t = (wall - ray_.origin[axis]) * inverse_[axis];
      count_.shift(lattice_.bits - depths[axis]);
      count_(Operation::add_long, 2);
      count_products(count_, 2);
      count_comparisons(count_, 1);
      if (t < exit_) {
        exit_ = t;
        exit_axis = axis;
      }
    }
    exit_ = std::max(exit_, t_);
    return exit_axis;
  }

  /// Steps to the block behind the wall; false if there is none.
  bool step(int exit_axis, const glm::uvec3& depths) {
    const glm::dvec3 point = ray_.at(exit_);
    const std::uint32_t end = end_of(exit_axis, depths);
    const std::uint32_t first = first_of(exit_axis, depths);
    count_products(count_, 4);
    count_(Operation::add_long, 4);
    count_comparisons(count_, 2);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == exit_axis) continue;
      at_[axis] = std::clamp(lattice_.cell(axis, point[axis]), first_of(axis, depths), end_of(axis, depths) - 1);
    }
    const bool is_up = ray_.direction[exit_axis] > 0;
    if (is_up ? end == lattice_.size() : first == 0) return false;
    at_[exit_axis] = is_up ? end : first - 1;
    return true;
  }

  const Lattice& lattice_;
  const SpaceRay& ray_;
  const Locate& locate_;
  Count& count_;
  glm::dvec3 inverse_;
  glm::uvec3 at_{0};
  double t_ = 0;
  double exit_ = 0;
  double end_ = 0;
};

}  // namespace csgsim::software
