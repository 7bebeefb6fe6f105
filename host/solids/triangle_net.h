// Half-edge triangulation of a flat outline, as in libtess2.
// Used by tessellation.cpp.
#pragma once

#include <cstdint>
#include <list>
#include <span>
#include <vector>

#include "host/solids/flat_outline.h"
#include "host/solids/tessellation.h"

namespace csgsim::solids {

/// Triangulates the region to the left of the sides of a flat outline. Each edge has two halves, one per direction,
/// with consecutive indices.
class TriangleNet {
 public:
  /// The sides must be simple, and the diagonals must divide the interior into monotone parts (flat_outline.h).
  TriangleNet(std::span<const ProjectedPoint> points, std::span<const Link> sides, std::span<const Link> diagonals);

  /// Cuts each part into triangles: a maximal fan at each point, from right to left.
  void cut_parts();

  /// Flips each diagonal whose two opposite angles sum to more than 180 degrees plus a tolerance.
  void flip_diagonals();

  [[nodiscard]] std::vector<OutlineTriangle> triangles() const;

 private:
  using Half = std::uint32_t;

  struct HalfEdge {
    std::uint32_t from = 0;
    Half next = 0;  ///< next half around the part to its left
    Half previous = 0;
    bool is_inside = true;   ///< whether a part is to its left
    bool is_queued = false;  ///< whether it is on the stack of flip_diagonals()
  };

  static Half other(Half half) { return half ^ 1U; }

  [[nodiscard]] const ProjectedPoint& from(Half half) const { return points_[edges_[half].from]; }
  [[nodiscard]] const ProjectedPoint& to(Half half) const { return from(other(half)); }
  [[nodiscard]] bool goes_right(Half half) const { return precedes(from(half), to(half)); }
  [[nodiscard]] bool goes_left(Half half) const { return precedes(to(half), from(half)); }
  [[nodiscard]] Half next(Half half) const { return edges_[half].next; }
  [[nodiscard]] Half previous(Half half) const { return edges_[half].previous; }
  [[nodiscard]] bool is_diagonal(Half half) const { return edges_[half].is_inside && edges_[other(half)].is_inside; }

  Half add_edge(const Link& link, bool is_diagonal);
  void join(Half half, Half next);
  void join_around_points();
  void find_parts();
  void cut_part(std::list<Half>::iterator part);
  Half cut_off_triangle(Half first, Half second, std::list<Half>::iterator part);
  /// Marks both halves of each inner diagonal as queued; returns one half of each.
  [[nodiscard]] std::vector<Half> queue_diagonals();
  [[nodiscard]] float opposite_angle(Half half) const;
  void flip_diagonal(Half half);
  void enqueue(Half half, std::vector<Half>& stack);

  std::span<const ProjectedPoint> points_;
  std::vector<HalfEdge> edges_;
  std::list<Half> parts_;  ///< one half of each part
};

}  // namespace csgsim::solids
