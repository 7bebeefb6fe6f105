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

/// Numbers of three planes that meet in one point, ascending.
using Triple = std::array<std::uint32_t, 3>;

/// The point of three planes in homogeneous coordinates, rounded: (x, y, z, w) with w > 0. Predicates that these leave
/// undecided are evaluated exactly from the planes.
struct Meeting {
  Triple planes{};
  std::array<double, 4> near{};
  double place_error = 0;   ///< what x, y and z together are off by at most
  double weight_error = 0;  ///< the same of w
};

/// The planes of a model as whole numbers, so that what is worked out of them is exact. Components of normals are
/// multiples of 2^-96, offsets of 2^-110 units; a unit is a power of two that is no less than twice the farthest
/// coordinate of the model, from the place that offsets are relative to. Doubles of a usual size are kept exactly, so
/// that small parts near that place are as exact as if they were alone, however large others are.
///
/// After the model's planes come walls, which are across the axes and divide the model where nothing else does.
class WholePlanes {
 public:
  /// Walls across an axis, evenly from one side of the model to the other; the first and last are outside of it.
  static constexpr std::uint32_t walls = 1025;

  /// Everything is no farther than half the table's diagonal from its centre.
  explicit WholePlanes(const facet::PlaneTable& planes) : WholePlanes(planes, planes.diagonal()) {}
  /// The same with another length than the diagonal.
  WholePlanes(const facet::PlaneTable& planes, double diameter);
  /// The box holds everything; it is relative to what the planes' offsets are relative to. Model units.
  WholePlanes(std::span<const facet::Plane> planes, const facet::Box& box);

  /// The unit of a box, in model units.
  static double unit_of(const facet::Box& box);
  /// A plane as it is held with such a unit: what is finer is rounded.
  static facet::Plane held(const facet::Plane& plane, double unit);

  /// How far apart units are, in model units.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] std::uint32_t wall(int axis, std::uint32_t number) const {
    return first_wall_ + static_cast<std::uint32_t>(axis) * walls + number;
  }
  /// The wall nearest to a place, but for the outermost ones.
  [[nodiscard]] std::uint32_t wall_near(int axis, double place) const;
  /// Its place, in units.
  [[nodiscard]] double place_of(std::uint32_t wall) const { return -near_[wall][3]; }

  /// The coefficients, exactly: normal and offset, in units.
  [[nodiscard]] const std::array<double, 4>& near(std::uint32_t plane) const { return near_[plane]; }
  /// Whether two planes have the same coefficients.
  [[nodiscard]] bool are_equal(std::uint32_t one, std::uint32_t other) const { return near_[one] == near_[other]; }
  [[nodiscard]] bool is_wall(std::uint32_t plane) const { return plane >= first_wall_; }

  /// How far a place, in units, is out of a half-space, as rounded numbers tell it.
  [[nodiscard]] double height(facet::Halfspace halfspace, const glm::dvec3& place) const {
    const std::array<double, 4>& near = near_[halfspace.plane];
    const double height = near[0] * place.x + near[1] * place.y + near[2] * place.z + near[3];
    return halfspace.positive ? height : -height;
  }

  /// The planes have to have one point in common.
  [[nodiscard]] Meeting meet(std::uint32_t one, std::uint32_t other, std::uint32_t third) const;

  /// Whether the point of three planes is on all of these; exact.
  [[nodiscard]] bool are_on(const Triple& point, std::span<const std::uint32_t> planes) const;

  /// The place of the point of three planes, in units; each coordinate is off by a few units of its last place.
  [[nodiscard]] glm::dvec3 exact_place(const Triple& planes) const;

  /// The same point as a Meeting, exactly: determinants of three rows, which take 315 bits.
  using Point = std::array<Wide<5>, 4>;

  /// -1 behind the plane, 0 on it, 1 before it; exact.
  [[nodiscard]] int side(const Meeting& point, std::uint32_t plane) const;
  /// The same. Keeps what it has to work out of the point alone for the next time.
  [[nodiscard]] int side(const Meeting& point, std::uint32_t plane, std::optional<Point>& exactly) const;

 private:
  using Row = std::array<Long, 4>;  ///< a normal's components and an offset

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

/// Its place in units, rounded.
inline glm::dvec3 place_of(const Meeting& point) {
  return glm::dvec3(point.near[0], point.near[1], point.near[2]) / point.near[3];
}

/// How far that is off along the axes together, at most, but for the rounding of the division.
inline double deviation_of(const Meeting& point) {
  const double coordinates = std::abs(point.near[0]) + std::abs(point.near[1]) + std::abs(point.near[2]);
  return (point.place_error + coordinates / point.near[3] * point.weight_error) / (point.near[3] - point.weight_error);
}

}  // namespace csgsim::software
