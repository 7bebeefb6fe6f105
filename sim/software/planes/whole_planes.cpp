#include "sim/software/planes/whole_planes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace csgsim::software {

namespace {

constexpr double normal_steps = 0x1p62;
constexpr int offset_bits = 110;  ///< steps of an offset in a unit, as a power of two
/// What a coordinate is to be multiplied by, where it is the quotient of determinants of rows.
constexpr double place_scale = normal_steps / 0x1p110;

/// In units. Planes farther away meet nothing of the model.
constexpr double farthest_plane = 512;

/// How far the outermost walls are from a model, as a part of its size.
constexpr double wall_margin = 0.25;

/// Off by some units of the last place: four products, each of them of a number that is off by two, and their sum.
constexpr double error_of_sum = 0x1p-49;

/// The least power of two that is no less.
double power_above(double length) {
  int exponent = 0;
  const double part = std::frexp(length, &exponent);
  return std::ldexp(1.0, part == 0.5 ? exponent - 1 : exponent);
}

std::int64_t normal_row(double component) { return std::llround(std::clamp(component, -1.0, 1.0) * normal_steps); }

double normal_of(std::int64_t row) { return static_cast<double>(row) / normal_steps; }

double offset_of(Long row) { return std::ldexp(static_cast<double>(row), -offset_bits); }

/// The nearest multiple of 2^-offset_bits.
Long offset_row(double units) {
  constexpr int mantissa_bits = 53;
  int exponent = 0;
  const double part = std::frexp(std::clamp(units, -farthest_plane, farthest_plane), &exponent);
  const int up = exponent - mantissa_bits + offset_bits;
  if (up < 0) return std::llround(std::ldexp(part, exponent + offset_bits));
  return static_cast<Long>(std::ldexp(part, mantissa_bits)) * (Long{1} << up);
}

facet::Box cube_of(double side) { return {glm::dvec3(-side / 2), glm::dvec3(side / 2)}; }

/// The box with room for the outermost walls.
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

WholePlanes::WholePlanes(std::span<const facet::Plane> planes, const facet::Box& box)
    : unit_(unit_of(box)) {
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
  for (const facet::Plane& plane : planes)
    add({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset / unit_});
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
  Row row;
  std::array<double, 4> near{};
  for (std::size_t i = 0; i < row.normal.size(); ++i) {
    row.normal[i] = normal_row(coefficients[i]);
    near[i] = normal_of(row.normal[i]);
  }
  row.offset = offset_row(coefficients[3]);
  near[3] = offset_of(row.offset);
  rows_.push_back(row);
  near_.push_back(near);
}

std::uint32_t WholePlanes::wall_near(int axis, double place) const {
  const double part = (place - walled_.low[axis]) / (walled_.high[axis] - walled_.low[axis]);
  const double number = std::round(part * (walls - 1));
  return wall(axis, static_cast<std::uint32_t>(std::clamp(number, 1.0, walls - 2.0)));
}

Meeting WholePlanes::meet(std::uint32_t one, std::uint32_t other, std::uint32_t third) const {
  Meeting point{{one, other, third}};
  std::sort(point.planes.begin(), point.planes.end());
  const Row& p = rows_[point.planes[0]];
  const Row& q = rows_[point.planes[1]];
  const Row& r = rows_[point.planes[2]];
  const auto of_normals = [&](std::size_t i, std::size_t j) {
    return static_cast<Long>(q.normal[i]) * r.normal[j] - static_cast<Long>(q.normal[j]) * r.normal[i];
  };
  const auto of_offsets = [&](std::size_t i) {
    Wide minor = Wide::product(r.offset, q.normal[i]);
    minor -= Wide::product(q.offset, r.normal[i]);
    return minor;
  };
  const std::array<Long, 3> normals{of_normals(1, 2), of_normals(0, 2), of_normals(0, 1)};
  const std::array<Wide, 3> offsets{of_offsets(0), of_offsets(1), of_offsets(2)};
  // The determinant of the columns i, j and that of the offsets, by the first row.
  const auto determinant = [&](std::size_t i, std::size_t j, Long of_offset) {
    Wide sum = offsets[j].times(p.normal[i]);
    sum -= offsets[i].times(p.normal[j]);
    sum += Wide::product(of_offset, p.offset);
    return sum;
  };
  Wide weight = Wide::product(normals[0], p.normal[0]);
  weight -= Wide::product(normals[1], p.normal[1]);
  weight += Wide::product(normals[2], p.normal[2]);
  point.exact = {determinant(1, 2, normals[0]), -determinant(0, 2, normals[1]), determinant(0, 1, normals[2]),
                 -weight};
  const int sign = point.exact[3].sign();
  if (sign == 0) throw std::logic_error("three planes do not meet in one point");
  for (std::size_t i = 0; i < point.exact.size(); ++i) {
    if (sign < 0) point.exact[i] = -point.exact[i];
    point.near[i] = point.exact[i].rounded() * (i < 3 ? place_scale : 1.0);
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
  for (std::size_t i = 0; i < 3; ++i) exact += point.exact[i].times(rows_[plane].normal[i]);
  exact += point.exact[3].times(rows_[plane].offset);
  return exact.sign();
}

}  // namespace csgsim::software
