#include "sim/software/planes/whole_planes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace csgsim::software {

namespace {

/// Numbers of fraction bits of a normal's component and of an offset in units.
constexpr int normal_bits = 96;
constexpr int offset_bits = 110;

/// Maximum stored offset, in units. Planes farther away do not intersect the model.
constexpr double farthest_plane = 512;

/// Distance of the outermost walls from the model, relative to its size.
constexpr double wall_margin = 0.25;

/// Bounds of rounding errors relative to the sum of the absolute values of all products: of a determinant of three
/// rows, and of a sum of four products.
constexpr double error_of_determinant = 0x1p-49;
constexpr double error_of_sum = 0x1p-49;

/// Points with a larger coordinate error, in units, are rounded from exact ones.
constexpr double max_error = 0x1p-34;

/// The smallest power of two that is at least `length`.
double power_above(double length) {
  int exponent = 0;
  const double part = std::frexp(length, &exponent);
  return std::ldexp(1.0, part == 0.5 ? exponent - 1 : exponent);
}

/// The nearest multiple of 2^-bits, as an integer multiple.
Long row_of(double number, int bits) {
  constexpr int mantissa_bits = 53;
  int exponent = 0;
  const double part = std::frexp(number, &exponent);
  const int up = exponent - mantissa_bits + bits;
  if (up < 0) return std::llround(std::ldexp(part, exponent + bits));
  return static_cast<Long>(std::ldexp(part, mantissa_bits)) * (Long{1} << up);
}

Long normal_row(double component) { return row_of(std::clamp(component, -1.0, 1.0), normal_bits); }
Long offset_row(double units) { return row_of(std::clamp(units, -farthest_plane, farthest_plane), offset_bits); }
double normal_of(Long row) { return std::ldexp(static_cast<double>(row), -normal_bits); }
double offset_of(Long row) { return std::ldexp(static_cast<double>(row), -offset_bits); }

facet::Box cube_of(double side) { return {glm::dvec3(-side / 2), glm::dvec3(side / 2)}; }

/// The box with a margin for the outermost walls.
facet::Box widened(const facet::Box& box) {
  const glm::dvec3 size = box.high - box.low;
  const double widest = std::max({size.x, size.y, size.z});
  const glm::dvec3 margin(wall_margin * (widest > 0 ? widest : 1.0));
  return {box.low - margin, box.high + margin};
}

double farthest_of(const facet::Box& box) {
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  return farthest > 0 ? farthest : 1.0;
}

}  // namespace

WholePlanes::WholePlanes(const facet::PlaneTable& planes, double diameter) : unit_(power_above(diameter)) {
  add_all(planes.planes(), widened(cube_of(1.0)));
}

WholePlanes::WholePlanes(std::span<const facet::Plane> planes, const facet::Box& box) : unit_(unit_of(box)) {
  add_all(planes, widened({box.low / unit_, box.high / unit_}));
}

double WholePlanes::unit_of(const facet::Box& box) { return power_above(2 * farthest_of(box)); }

facet::Plane WholePlanes::held(const facet::Plane& plane, double unit) {
  facet::Plane held;
  for (int axis = 0; axis < 3; ++axis) held.normal[axis] = normal_of(normal_row(plane.normal[axis]));
  held.offset = offset_of(offset_row(plane.offset / unit)) * unit;
  return held;
}

void WholePlanes::add_all(std::span<const facet::Plane> planes, const facet::Box& walled) {
  walled_ = walled;
  const std::size_t count = planes.size() + std::size_t{3} * walls;
  rows_.reserve(count);
  near_.reserve(count);
  for (const facet::Plane& plane : planes) add({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset / unit_});
  first_wall_ = static_cast<std::uint32_t>(rows_.size());
  for (int axis = 0; axis < 3; ++axis) {
    const double size = walled.high[axis] - walled.low[axis];
    for (std::uint32_t i = 0; i < walls; ++i) {
      std::array<double, 4> coefficients{0, 0, 0, -(walled.low[axis] + size * i / (walls - 1))};
      coefficients[static_cast<std::size_t>(axis)] = 1;
      add(coefficients);
    }
  }
}

void WholePlanes::add(const std::array<double, 4>& coefficients) {
  Row row{};
  std::array<double, 4> near{};
  for (std::size_t i = 0; i < 3; ++i) {
    row[i] = normal_row(coefficients[i]);
    near[i] = normal_of(row[i]);
  }
  row[3] = offset_row(coefficients[3]);
  near[3] = offset_of(row[3]);
  rows_.push_back(row);
  near_.push_back(near);
}

std::uint32_t WholePlanes::wall_near(int axis, double place) const {
  const double part = (place - walled_.low[axis]) / (walled_.high[axis] - walled_.low[axis]);
  const double number = std::round(part * (walls - 1));
  return wall(axis, static_cast<std::uint32_t>(std::clamp(number, 1.0, walls - 2.0)));
}

namespace {

/// The determinant of three columns of three rows, and the sum of the absolute values of its products.
struct Determinant {
  double value = 0;
  double size = 0;
};

using NearRow = std::array<double, 4>;

Determinant determinant(const NearRow& p, const NearRow& q, const NearRow& r,
                        const std::array<std::size_t, 3>& columns) {
  Determinant sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = columns[i];
    const std::size_t b = columns[(i + 1) % 3];
    const std::size_t c = columns[(i + 2) % 3];
    const double one = q[b] * r[c];
    const double other = q[c] * r[b];
    sum.value += p[a] * (one - other);
    sum.size += std::abs(p[a]) * (std::abs(one) + std::abs(other));
  }
  return sum;
}

/// Columns of the determinants that give x, y, z and w.
constexpr std::array<std::array<std::size_t, 3>, 4> columns_of{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace

WholePlanes::Point WholePlanes::exact(const Triple& planes) const {
  const Row& p = rows_[planes[0]];
  const Row& q = rows_[planes[1]];
  const Row& r = rows_[planes[2]];
  std::array<std::array<Wide<4>, 4>, 4> minors;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      minors[i][j] = product(q[i], r[j]);
      minors[i][j] -= product(q[j], r[i]);
      minors[j][i] = -minors[i][j];
    }
  }
  Point point;
  for (std::size_t k = 0; k < point.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = columns_of[k][i];
      const std::size_t b = columns_of[k][(i + 1) % 3];
      const std::size_t c = columns_of[k][(i + 2) % 3];
      if (p[a] != 0) point[k] += product<5>(minors[b][c], p[a]);
    }
  }
  const int sign = point[3].sign();
  if (sign == 0) throw std::logic_error("three planes do not meet in one point");
  if (sign < 0)
    for (Wide<5>& one : point) one = -one;
  return point;
}

int WholePlanes::side(const Point& point, std::uint32_t plane) const {
  Wide<7> height;  // a determinant of four rows, which needs 413 bits
  for (std::size_t i = 0; i < point.size(); ++i)
    if (rows_[plane][i] != 0) height += product<7>(point[i], rows_[plane][i]);
  return height.sign();
}

bool WholePlanes::is_on_all(const Triple& point, std::span<const std::uint32_t> planes) const {
  const auto is_known = [&](std::uint32_t plane) { return std::ranges::find(point, plane) != point.end(); };
  if (std::ranges::all_of(planes, is_known)) return true;
  const Point exactly = exact(point);
  return std::ranges::all_of(planes, [&](std::uint32_t plane) { return is_known(plane) || side(exactly, plane) == 0; });
}

Meeting WholePlanes::exactly_rounded(const Triple& planes) const {
  constexpr double error_of_rounding = 0x1p-51;
  Meeting point{.planes = planes};
  const Point exactly = exact(planes);
  for (std::size_t i = 0; i < 3; ++i) {
    point.near[i] = std::ldexp(exactly[i].rounded(), -2 * normal_bits - offset_bits);
    point.place_error += std::abs(point.near[i]) * error_of_rounding;
  }
  point.near[3] = std::ldexp(exactly[3].rounded(), -3 * normal_bits);
  point.weight_error = point.near[3] * error_of_rounding;
  return point;
}

Meeting WholePlanes::meet(std::uint32_t one, std::uint32_t other, std::uint32_t third) const {
  Meeting point{.planes = {one, other, third}};
  std::sort(point.planes.begin(), point.planes.end());
  const NearRow& p = near_[point.planes[0]];
  const NearRow& q = near_[point.planes[1]];
  const NearRow& r = near_[point.planes[2]];
  for (std::size_t k = 0; k < point.near.size(); ++k) {
    const Determinant found = determinant(p, q, r, columns_of[k]);
    point.near[k] = found.value;
    (k < 3 ? point.place_error : point.weight_error) += error_of_determinant * found.size;
  }
  const double weight = std::abs(point.near[3]);
  if (!(point.place_error <= max_error * weight && point.weight_error <= max_error * weight))
    return exactly_rounded(point.planes);
  if (point.near[3] < 0)
    for (double& near : point.near) near = -near;
  return point;
}

glm::dvec3 WholePlanes::exact_position(const Triple& planes) const {
  return software::place_of(exactly_rounded(planes));
}

int WholePlanes::side(const Meeting& point, std::uint32_t plane) const {
  std::optional<Point> exactly;
  return side(point, plane, exactly);
}

int WholePlanes::side(const Meeting& point, std::uint32_t plane, std::optional<Point>& exactly) const {
  if (plane == point.planes[0] || plane == point.planes[1] || plane == point.planes[2]) return 0;
  const NearRow& near = near_[plane];
  double sum = 0;
  double size = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const double part = near[i] * point.near[i];
    sum += part;
    size += std::abs(part);
  }
  const double error = error_of_sum * size + point.place_error + std::abs(near[3]) * point.weight_error;
  if (std::abs(sum) > error) return sum < 0 ? -1 : 1;
  if (!exactly) exactly = exact(point.planes);
  return side(*exactly, plane);
}

}  // namespace csgsim::software
