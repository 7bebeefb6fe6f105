#include "sim/software/planes/whole_planes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace csgsim::software {

namespace {

constexpr double steps_per_unit = 0x1p53;

/// In steps. Planes farther from the middle meet nothing of the model, whose points are within half a unit.
constexpr double farthest_plane = 0x1p62;

/// Nothing of a model is farther from its middle than half a unit.
constexpr double outermost_wall = 0.75;

/// Off by some units of the last place: four products, each of them of a number that is off by two, and their sum.
constexpr double error_of_sum = 0x1p-49;

/// The least power of two that is no less.
double power_above(double length) {
  int exponent = 0;
  const double part = std::frexp(length, &exponent);
  return std::ldexp(1.0, part == 0.5 ? exponent - 1 : exponent);
}

}  // namespace

WholePlanes::WholePlanes(const facet::PlaneTable& planes, double diameter) : unit_(power_above(diameter)) {
  const std::size_t count = planes.planes().size() + 3 * walls;
  rows_.reserve(count);
  near_.reserve(count);
  for (const facet::Plane& plane : planes.planes()) {
    add({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset / unit_});
  }
  first_wall_ = static_cast<std::uint32_t>(rows_.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::uint32_t i = 0; i < walls; ++i) {
      std::array<double, 4> coefficients{0, 0, 0, outermost_wall * (1.0 - 2.0 * i / (walls - 1))};
      coefficients[axis] = 1;
      add(coefficients);
    }
  }
}

void WholePlanes::add(const std::array<double, 4>& coefficients) {
  Row row{};
  std::array<double, 4> near{};
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] = std::llround(std::clamp(coefficients[i] * steps_per_unit, -farthest_plane, farthest_plane));
    near[i] = static_cast<double>(row[i]) / steps_per_unit;
  }
  rows_.push_back(row);
  near_.push_back(near);
}

std::uint32_t WholePlanes::wall_near(int axis, double place) const {
  const double number = std::round((place / outermost_wall + 1.0) / 2.0 * (walls - 1));
  return wall(axis, static_cast<std::uint32_t>(std::clamp(number, 1.0, walls - 2.0)));
}

Meeting WholePlanes::meet(std::uint32_t one, std::uint32_t other, std::uint32_t third) const {
  Meeting point{{one, other, third}};
  std::sort(point.planes.begin(), point.planes.end());
  const Row& p = rows_[point.planes[0]];
  const Row& q = rows_[point.planes[1]];
  const Row& r = rows_[point.planes[2]];
  const auto minor = [&](std::size_t i, std::size_t j) {
    return static_cast<Long>(q[i]) * r[j] - static_cast<Long>(q[j]) * r[i];
  };
  const std::array<Long, 6> minors{minor(0, 1), minor(0, 2), minor(0, 3), minor(1, 2), minor(1, 3), minor(2, 3)};
  // The determinant of three columns, by the first row.
  const auto determinant = [](std::int64_t a, Long of_a, std::int64_t b, Long of_b, std::int64_t c, Long of_c) {
    Wide sum = Wide::product(of_a, a);
    sum -= Wide::product(of_b, b);
    sum += Wide::product(of_c, c);
    return sum;
  };
  point.exact = {determinant(p[1], minors[5], p[2], minors[4], p[3], minors[3]),
                 -determinant(p[0], minors[5], p[2], minors[2], p[3], minors[1]),
                 determinant(p[0], minors[4], p[1], minors[2], p[3], minors[0]),
                 -determinant(p[0], minors[3], p[1], minors[1], p[2], minors[0])};
  const int sign = point.exact[3].sign();
  if (sign == 0) throw std::logic_error("three planes do not meet in one point");
  for (std::size_t i = 0; i < point.exact.size(); ++i) {
    if (sign < 0) point.exact[i] = -point.exact[i];
    point.near[i] = point.exact[i].rounded();
  }
  return point;
}

int WholePlanes::side(const Meeting& point, std::uint32_t plane) const {
  if (plane == point.planes[0] || plane == point.planes[1] || plane == point.planes[2]) return 0;
  const std::array<double, 4>& near = near_[plane];
  double sum = 0;
  double size = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const double part = near[i] * point.near[i];
    sum += part;
    size += std::abs(part);
  }
  if (std::abs(sum) > error_of_sum * size) return sum < 0 ? -1 : 1;
  Wide exact;
  for (std::size_t i = 0; i < near.size(); ++i) exact += point.exact[i].times(rows_[plane][i]);
  return exact.sign();
}

}  // namespace csgsim::software
