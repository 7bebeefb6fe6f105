#pragma once

#include <cstdint>
#include <list>
#include <span>
#include <vector>

#include "host/solids/flat_outline.h"
#include "host/solids/tessellation.h"

namespace csgsim::solids {

/// Makes triangles of what is to the left of the sides of a flat outline, part by part. An edge is two halves, one in
/// each direction, with numbers next to each other.
class TriangleNet {
 public:
  /// The sides have to be simple, and the diagonals to part what is inside into monotone parts (flat_outline.h).
  TriangleNet(std::span<const SeenPoint> points, std::span<const Link> sides, std::span<const Link> diagonals);

  /// Cuts each part into triangles: a fan at each point, from right to left, as large as can be.
  void cut_parts();

  /// Turns diagonals while the two angles that are opposite to one are more than 180 degrees and some together.
  void turn_diagonals();

  [[nodiscard]] std::vector<OutlineTriangle> triangles() const;

 private:
  using Half = std::uint32_t;

  struct HalfEdge {
    std::uint32_t from = 0;
    Half next = 0;  ///< around the part to its left
    Half previous = 0;
    bool is_inside = true;    ///< whether a part is to its left
    bool is_waiting = false;  ///< to be looked at, on the stack of turn_diagonals()
  };

  static Half other(Half half) { return half ^ 1U; }

  [[nodiscard]] const SeenPoint& from(Half half) const { return points_[edges_[half].from]; }
  [[nodiscard]] const SeenPoint& to(Half half) const { return from(other(half)); }
  [[nodiscard]] bool goes_right(Half half) const { return comes_before(from(half), to(half)); }
  [[nodiscard]] bool goes_left(Half half) const { return comes_before(to(half), from(half)); }
  [[nodiscard]] Half next(Half half) const { return edges_[half].next; }
  [[nodiscard]] Half previous(Half half) const { return edges_[half].previous; }
  [[nodiscard]] bool is_diagonal(Half half) const { return edges_[half].is_inside && edges_[other(half)].is_inside; }

  Half add_edge(const Link& link, bool is_diagonal);
  void join(Half half, Half next);
  void join_around_points();
  void find_parts();
  void cut_part(std::list<Half>::iterator part);
  Half cut_off(Half one, Half two, std::list<Half>::iterator part);
  [[nodiscard]] std::vector<Half> diagonals();
  [[nodiscard]] float opposite_angle(Half half) const;
  void turn_diagonal(Half half);
  void wait(Half half, std::vector<Half>& stack);

  std::span<const SeenPoint> points_;
  std::vector<HalfEdge> edges_;
  std::list<Half> parts_;  ///< a half of each
};

}  // namespace csgsim::solids
