// Planes with exact arithmetic.
// Used by mesh conversion and by list priority.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "sim/software/planes/wide.h"

namespace csgsim::software {

/// Indices of three planes that intersect in one point, ascending.
using Triple = std::array<std::uint32_t, 3>;

/// The intersection point of three planes in homogeneous coordinates (x, y, z, w), w > 0, rounded. Predicates that are
/// undecided by these are evaluated exactly from the planes.
struct Meeting {
  Triple planes{};
  std::array<double, 4> near{};
  double place_error = 0;   ///< maximum total error of x, y and z
  double weight_error = 0;  ///< maximum error of w
};

/// The planes of a model as integers, so that everything derived from them is exact. Components of normals are
/// multiples of 2^-96, offsets of 2^-110 units. A unit is a power of two of at least twice the maximum coordinate of
/// the model, relative to the origin of the offsets. Doubles of ordinary magnitude are represented exactly, so that
/// small parts near that origin are as exact as if they were alone, regardless of the size of others.
///
/// The model's planes are followed by walls, which are perpendicular to the axes and divide the model where nothing
/// else does.
class WholePlanes {
 public:
  /// Number of walls per axis, evenly spaced across the model; the first and last are outside of it.
  static constexpr std::uint32_t walls = 1025;

  /// All points must be within half the table's diagonal of its centre.
  explicit WholePlanes(const facet::PlaneTable& planes) : WholePlanes(planes, planes.diagonal()) {}
  /// All points must be within half of `diameter` of the table's centre.
  WholePlanes(const facet::PlaneTable& planes, double diameter);
  /// The box must contain everything; it has the same origin as the planes' offsets. In model units.
  WholePlanes(std::span<const facet::Plane> planes, const facet::Box& box);

  /// The unit of a box, in model units.
  static double unit_of(const facet::Box& box);
  /// A plane as represented with that unit: smaller differences are rounded.
  static facet::Plane held(const facet::Plane& plane, double unit);

  /// Length of a unit in model units.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] std::uint32_t wall(int axis, std::uint32_t number) const {
    return first_wall_ + static_cast<std::uint32_t>(axis) * walls + number;
  }
  /// The wall nearest to a position, excluding the outermost ones.
  [[nodiscard]] std::uint32_t wall_near(int axis, double position) const;
  /// Position of a wall, in units.
  [[nodiscard]] double place_of(std::uint32_t wall) const { return -near_[wall][3]; }

  /// Normal and offset as held, in units; exact, unlike Meeting::near.
  [[nodiscard]] const std::array<double, 4>& coefficients(std::uint32_t plane) const { return near_[plane]; }
  /// Whether two planes have the same coefficients.
  [[nodiscard]] bool are_equal(std::uint32_t one, std::uint32_t other) const { return near_[one] == near_[other]; }
  [[nodiscard]] bool is_wall(std::uint32_t plane) const { return plane >= first_wall_; }

  /// Height of a position, in units, outside a half-space, in rounded arithmetic.
  [[nodiscard]] double height(facet::Halfspace halfspace, const glm::dvec3& place) const {
    const std::array<double, 4>& near = near_[halfspace.plane];
    const double height = near[0] * place.x + near[1] * place.y + near[2] * place.z + near[3];
    return halfspace.positive ? height : -height;
  }

  /// The planes must intersect in one point.
  [[nodiscard]] Meeting meet(std::uint32_t one, std::uint32_t other, std::uint32_t third) const;

  /// Whether the point of three planes lies on all of these planes; exact.
  [[nodiscard]] bool is_on_all(const Triple& point, std::span<const std::uint32_t> planes) const;

  /// Position of the point of three planes, in units; the error of each coordinate is a few units in the last place.
  [[nodiscard]] glm::dvec3 exact_position(const Triple& planes) const;

  /// The exact point of a Meeting: determinants of three rows, which need 315 bits.
  using Point = std::array<Wide<5>, 4>;

  /// -1 behind the plane, 0 on it, 1 in front of it; exact.
  [[nodiscard]] int side(const Meeting& point, std::uint32_t plane) const;
  /// -1 behind the plane, 0 on it, 1 in front of it; exact. Stores the exact point in `exactly`, if it was needed, for
  /// later calls.
  [[nodiscard]] int side(const Meeting& point, std::uint32_t plane, std::optional<Point>& exactly) const;

 private:
  using Row = std::array<Long, 4>;  ///< components of a normal, and an offset

  void add_all(std::span<const facet::Plane> planes, const facet::Box& walled);
  void add(const std::array<double, 4>& coefficients);
  [[nodiscard]] Point exact(const Triple& planes) const;
  [[nodiscard]] int side(const Point& point, std::uint32_t plane) const;
  [[nodiscard]] Meeting exactly_rounded(const Triple& planes) const;

  double unit_ = 1;
  std::uint32_t first_wall_ = 0;
  facet::Box walled_;  ///< in units; the outermost walls are its sides
  std::vector<Row> rows_;
  std::vector<std::array<double, 4>> near_;
};

/// Position in units, rounded.
inline glm::dvec3 place_of(const Meeting& point) {
  return glm::dvec3(point.near[0], point.near[1], point.near[2]) / point.near[3];
}

/// Maximum total error of the position along the axes, apart from the rounding of the division.
inline double deviation_of(const Meeting& point) {
  const double coordinates = std::abs(point.near[0]) + std::abs(point.near[1]) + std::abs(point.near[2]);
  return (point.place_error + coordinates / point.near[3] * point.weight_error) / (point.near[3] - point.weight_error);
}

}  // namespace csgsim::software
