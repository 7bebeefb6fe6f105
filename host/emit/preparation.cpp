#include "host/emit/preparation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace csgsim::emit {

namespace {

using Long = std::int64_t;

/// A number as the host stores it: a fraction of `unit` with 31 bits.
Long to_long(double value, double unit) {
  constexpr double scale = 0x1p31;
  return std::llround(std::clamp(value / unit, -1.0, 1.0) * scale);
}

template <class Item>
std::uint64_t count_different(std::vector<Item>& items) {
  std::ranges::sort(items);
  return static_cast<std::uint64_t>(std::unique(items.begin(), items.end()) - items.begin());
}

/// The largest absolute coordinate relative to the middle of the planes; at least the smallest normal double.
double unit_of(const facet::Geometry& geometry) {
  double most = std::numeric_limits<double>::min();
  for (const facet::Convex& solid : geometry.solids) {
    for (const glm::dvec3& vertex : solid.vertices) {
      const glm::dvec3 from_centre = vertex - geometry.planes.centre();
      for (int axis = 0; axis < 3; ++axis) most = std::max(most, std::abs(from_centre[axis]));
    }
  }
  return most;
}

constexpr std::uint64_t axes = 3;
constexpr std::uint64_t corners_of_box = 8;
constexpr std::uint64_t coordinates_of_box = 6;

}  // namespace

DistinctNumbers count_distinct_numbers(const facet::Geometry& geometry) {
  DistinctNumbers distinct;
  std::vector<Long> numbers;
  const double unit = unit_of(geometry);
  for (int axis = 0; axis < 3; ++axis) {
    numbers.clear();
    for (const facet::Convex& solid : geometry.solids)
      for (const glm::dvec3& vertex : solid.vertices)
        numbers.push_back(to_long(vertex[axis] - geometry.planes.centre()[axis], unit));
    distinct.coordinates += count_different(numbers);
    numbers.clear();
    for (const facet::Plane& plane : geometry.planes.planes())
      numbers.push_back(std::abs(to_long(plane.normal[axis], 1)));
    distinct.components += count_different(numbers);
  }
  std::vector<std::array<Long, axes>> directions;
  for (const facet::Plane& plane : geometry.planes.planes())
    directions.push_back({to_long(plane.normal.x, 1), to_long(plane.normal.y, 1), to_long(plane.normal.z, 1)});
  distinct.directions = count_different(directions);
  for (const facet::Convex& solid : geometry.solids)
    if (solid.vertices.empty()) distinct.coordinates += coordinates_of_box;
  return distinct;
}

isa::Preparation count_sharing_work(const facet::Geometry& geometry) {
  isa::Preparation preparation;
  preparation.nodes = geometry.halfspaces() + (axes + 1) * geometry.planes.planes().size();
  for (const facet::Convex& solid : geometry.solids)
    preparation.nodes += solid.vertices.empty() ? coordinates_of_box : axes * solid.vertices.size();
  return preparation;
}

isa::Preparation count_preparation(const facet::Geometry& geometry, const view::View& view,
                                   const DistinctNumbers& distinct, bool is_sample) {
  // A quadric has ten coefficients and a plane four, so that a quadric counts as three planes, whose 16 numbers each
  // are multiplied by the matrix.
  constexpr std::uint64_t planes_of_quadric = 3;
  constexpr std::uint64_t products_of_plane = 16;
  isa::Preparation preparation;
  const std::uint64_t quadric_planes = planes_of_quadric * view.quadrics.size();
  preparation.planes = view.planes.size() + quadric_planes;
  for (const facet::Convex& solid : geometry.solids)
    preparation.points += solid.vertices.empty() ? corners_of_box : solid.vertices.size();
  if (is_sample) return preparation;
  // A coordinate of a corner adds to three coordinates in the picture, a component of a normal also to the offset.
  preparation.products =
      axes * distinct.coordinates + (axes + 1) * distinct.components + products_of_plane * quadric_planes;
  const bool is_perspective = view.camera.projection == view::Projection::perspective;
  preparation.quotients =
      (is_perspective ? view.planes.size() + preparation.points : distinct.directions) + quadric_planes;
  return preparation;
}

}  // namespace csgsim::emit
