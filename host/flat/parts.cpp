#include "host/flat/parts.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "host/model/exact_coordinate.h"

namespace csgsim::flat {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

constexpr std::uint32_t none = 0xffffffffU;

struct FaceInfo {
  std::optional<bool> inside;
  std::uint32_t first_edge = none;  ///< first half-edge of an inner triangle, opposite to its vertex 0
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage, CGAL::Exact_predicates_tag>;
using Triangulation = CGAL::Constrained_triangulation_plus_2<Delaunay>;
using FaceHandle = Triangulation::Face_handle;
using VertexHandle = Triangulation::Vertex_handle;

void insert(Triangulation& triangulation, const Outline& outline) {
  std::vector<VertexHandle> corners;
  corners.reserve(outline.size());
  FaceHandle near;
  for (const glm::dvec2& corner : outline) {
    corners.push_back(triangulation.insert(model::exact_point<Point>(corner.x, corner.y), near));
    near = corners.back()->face();
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const VertexHandle next = corners[(i + 1) % corners.size()];
    if (corners[i] != next) triangulation.insert_constraint(corners[i], next);
  }
}

/// Whether the area ends at the edge, which is so if an odd number of sides run along it.
bool is_border(const Triangulation& triangulation, FaceHandle face, int index) {
  if (!face->is_constrained(index)) return false;
  const VertexHandle a = face->vertex(Triangulation::cw(index));
  const VertexHandle b = face->vertex(Triangulation::ccw(index));
  return triangulation.number_of_enclosing_constraints(a, b) % 2 == 1;
}

/// Marks every face as inside or outside, from the infinite face inwards.
void mark_inside(const Triangulation& triangulation) {
  std::vector<FaceHandle> open{triangulation.infinite_face()};
  open.front()->info().inside = false;
  while (!open.empty()) {
    const FaceHandle face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const FaceHandle neighbour = face->neighbor(i);
      if (neighbour->info().inside) continue;
      neighbour->info().inside = *face->info().inside != is_border(triangulation, face, i);
      open.push_back(neighbour);
    }
  }
}

/// A side of a polygon, counter-clockwise around it.
struct HalfEdge {
  std::uint32_t from = none;  ///< point index
  std::uint32_t next = none;
  std::uint32_t previous = none;
  std::uint32_t twin = none;  ///< `none` at the border of the area
};

/// Polygons that share sides.
struct Partition {
  std::vector<Point> points;
  std::vector<HalfEdge> edges;

  [[nodiscard]] const Point& start(std::uint32_t edge) const { return points[edges[edge].from]; }
};

Partition triangles(const Triangulation& triangulation) {
  Partition partition;
  for (const VertexHandle vertex : triangulation.finite_vertex_handles()) {
    vertex->info() = static_cast<std::uint32_t>(partition.points.size());
    partition.points.push_back(vertex->point());
  }
  for (const FaceHandle face : triangulation.finite_face_handles()) {
    if (!*face->info().inside) continue;
    const auto first = static_cast<std::uint32_t>(partition.edges.size());
    face->info().first_edge = first;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t from = face->vertex(Triangulation::ccw(static_cast<int>(i)))->info();
      partition.edges.push_back({from, first + (i + 1) % 3, first + (i + 2) % 3, none});
    }
  }
  for (const FaceHandle face : triangulation.finite_face_handles()) {
    if (!*face->info().inside) continue;
    for (int i = 0; i < 3; ++i) {
      const FaceHandle neighbour = face->neighbor(i);
      if (!*neighbour->info().inside || is_border(triangulation, face, i)) continue;
      partition.edges[face->info().first_edge + static_cast<std::uint32_t>(i)].twin =
          neighbour->info().first_edge + static_cast<std::uint32_t>(neighbour->index(face));
    }
  }
  return partition;
}

/// Whether the corner at the start of `out` stays convex if the diagonal is removed and `in` and `out` become adjacent.
bool stays_convex(const Partition& partition, std::uint32_t in, std::uint32_t out) {
  if (partition.edges[in].twin == out) return false;
  return CGAL::orientation(partition.start(in), partition.start(out), partition.start(partition.edges[out].next)) !=
         CGAL::RIGHT_TURN;
}

bool is_needless(const Partition& partition, std::uint32_t diagonal) {
  const HalfEdge& one = partition.edges[diagonal];
  const HalfEdge& other = partition.edges[one.twin];
  return stays_convex(partition, one.previous, other.next) && stays_convex(partition, other.previous, one.next);
}

void remove(Partition& partition, std::uint32_t diagonal) {
  const HalfEdge one = partition.edges[diagonal];
  const HalfEdge other = partition.edges[one.twin];
  const auto join = [&](std::uint32_t in, std::uint32_t out) {
    partition.edges[in].next = out;
    partition.edges[out].previous = in;
  };
  join(one.previous, other.next);
  join(other.previous, one.next);
  partition.edges[diagonal].next = none;
  partition.edges[one.twin].next = none;
}

/// Marks the points at which the area's border is reflex, where a cut is needed.
std::vector<bool> reflex_points(const Partition& partition) {
  std::vector<bool> reflex(partition.points.size(), false);
  for (std::uint32_t out = 0; out < partition.edges.size(); ++out) {
    if (partition.edges[out].twin != none) continue;
    std::uint32_t in = partition.edges[out].previous;
    while (partition.edges[in].twin != none) in = partition.edges[partition.edges[in].twin].previous;
    const Point& after = partition.start(partition.edges[out].next);
    if (CGAL::orientation(partition.start(in), partition.start(out), after) == CGAL::RIGHT_TURN) {
      reflex[partition.edges[out].from] = true;
    }
  }
  return reflex;
}

/// The order in which diagonals are tried. Which order is best depends on the area.
enum class Order {
  longest_first,
  loose_first,          ///< diagonals with fewer reflex ends first; among equals, the longest first
  loose_shortest_first  ///< diagonals with fewer reflex ends first; among equals, the shortest first
};

constexpr std::array<Order, 3> orders{Order::longest_first, Order::loose_first, Order::loose_shortest_first};

std::vector<std::uint32_t> diagonals(const Partition& partition, const std::vector<bool>& reflex, Order order) {
  using Key = std::tuple<int, double, Point, Point, std::uint32_t>;
  std::vector<Key> keys;
  for (std::uint32_t edge = 0; edge < partition.edges.size(); ++edge) {
    const HalfEdge& half = partition.edges[edge];
    if (half.twin == none || half.twin < edge) continue;
    const Point& a = partition.start(edge);
    const Point& b = partition.start(half.next);
    const int ends = (reflex[half.from] ? 1 : 0) + (reflex[partition.edges[half.next].from] ? 1 : 0);
    const double length = CGAL::squared_distance(a, b);
    keys.emplace_back(order == Order::longest_first ? 0 : ends, order == Order::loose_shortest_first ? length : -length,
                      std::min(a, b), std::max(a, b), edge);
  }
  std::ranges::sort(keys, std::less<Key>());
  std::vector<std::uint32_t> result;
  result.reserve(keys.size());
  for (const Key& key : keys) result.push_back(std::get<4>(key));
  return result;
}

/// Removes the needless diagonals in the given order. Returns their number.
std::size_t remove_needless(Partition& partition, std::span<const std::uint32_t> ordered) {
  std::size_t removed = 0;
  for (const std::uint32_t diagonal : ordered) {
    if (!is_needless(partition, diagonal)) continue;
    remove(partition, diagonal);
    ++removed;
  }
  return removed;
}

/// Merges triangles into convex polygons, in the order that leaves the fewest diagonals.
Partition merged(const Partition& triangles) {
  const std::vector<bool> reflex = reflex_points(triangles);
  Partition best = triangles;
  std::optional<std::size_t> most;
  for (const Order order : orders) {
    Partition partition = triangles;
    const std::size_t removed = remove_needless(partition, diagonals(triangles, reflex, order));
    if (most && removed <= *most) continue;
    most = removed;
    best = std::move(partition);
  }
  return best;
}

Outline outline_at(const Partition& partition, std::uint32_t first) {
  Outline outline;
  std::uint32_t edge = first;
  do {
    const Point& point = partition.start(edge);
    const HalfEdge& side = partition.edges[edge];
    if (CGAL::orientation(partition.start(side.previous), point, partition.start(side.next)) != CGAL::COLLINEAR) {
      outline.emplace_back(point.x(), point.y());
    }
    edge = side.next;
  } while (edge != first);
  return outline;
}

std::vector<Outline> outlines(const Partition& partition) {
  std::vector<Outline> result;
  std::vector<bool> seen(partition.edges.size(), false);
  for (std::uint32_t first = 0; first < partition.edges.size(); ++first) {
    if (seen[first] || partition.edges[first].next == none) continue;
    for (std::uint32_t edge = first; !seen[edge]; edge = partition.edges[edge].next) seen[edge] = true;
    result.push_back(outline_at(partition, first));
  }
  return result;
}

/// Whether the outline turns to the left at every corner and winds around once; rejects collinear corners.
bool is_convex(const Outline& outline) {
  const std::size_t count = outline.size();
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2& before = outline[(i + count - 1) % count];
    const glm::dvec2& here = outline[i];
    const glm::dvec2& after = outline[(i + 1) % count];
    const Point point(here.x, here.y);
    const Point in(before.x, before.y);
    const Point out(after.x, after.y);
    if (CGAL::orientation(in, point, out) != CGAL::LEFT_TURN) return false;
    if (point < in && point < out) ++lowest;
  }
  return lowest == 1;
}

}  // namespace

std::vector<Outline> convex_parts(const Area& area) {
  if (area.outlines.size() == 1 && is_convex(area.outlines[0])) return area.outlines;
  Triangulation triangulation;
  for (const Outline& outline : area.outlines) insert(triangulation, outline);
  if (triangulation.dimension() < 2) return {};
  mark_inside(triangulation);
  return outlines(merged(triangles(triangulation)));
}

}  // namespace csgsim::flat
