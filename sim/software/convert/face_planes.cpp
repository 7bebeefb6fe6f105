#include "sim/software/convert/face_planes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "host/facet/coincidence.h"
#include "sim/software/planes/whole_planes.h"

namespace csgsim::software::convert {

namespace {

/// Maximum distance between two planes within a ball.
double max_distance(const facet::Plane& one, const facet::Plane& other, const Footprint& ball) {
  const glm::dvec3 turn = one.normal - other.normal;
  return std::abs(glm::dot(turn, ball.middle) + one.offset - other.offset) + glm::length(turn) * ball.radius;
}

/// Exact unless products underflow.
bool are_products_equal(double a, double b, double c, double d) {
  const double one = a * b;
  const double other = c * d;
  return one == other && std::fma(a, b, -one) == std::fma(c, d, -other);
}

/// Whether two planes contain the same points.
bool are_equal(const facet::Plane& one, const facet::Plane& other) {
  const std::array<double, 4> a{one.normal.x, one.normal.y, one.normal.z, one.offset};
  const std::array<double, 4> b{other.normal.x, other.normal.y, other.normal.z, other.offset};
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!are_products_equal(a[i], b[j], a[j], b[i])) return false;
  return true;
}

}  // namespace

facet::Key<4> FacePlanes::key_of(const facet::Plane& plane) const {
  return {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset / diagonal_};
}

bool FacePlanes::may_share(const facet::Plane& canonical, bool positive, std::uint32_t known) const {
  const facet::Plane& other = planes_[known];
  if (are_equal(canonical, other)) return true;
  const Use& use = uses_[known];
  if (use.last + 1 == solids_.size() && use.positive != positive) return false;
  const auto is_within = [&](const Footprint& solid) {
    return max_distance(canonical, other, solid) <= solid.tolerance;
  };
  return is_within(solids_.back()) && is_within(solids_[use.first]);
}

std::optional<std::uint32_t> FacePlanes::find(const facet::Plane& canonical, bool positive) const {
  const facet::Key<4> key = key_of(canonical);
  std::optional<std::uint32_t> first;
  facet::for_each_near_cell(key, [&](const facet::Key<4>& cell) {
    const auto [begin, end] = at_.equal_range(facet::hash_of(cell));
    for (auto one = begin; one != end; ++one) {
      const std::uint32_t plane = one->second;
      if ((first && plane >= *first) || !facet::are_near(key, key_of(planes_[plane]))) continue;
      if (may_share(canonical, positive, plane)) first = plane;
    }
  });
  return first;
}

facet::Halfspace FacePlanes::add(const facet::Plane& plane) {
  facet::Plane canonical{plane.normal, plane.offset + glm::dot(plane.normal, reference_)};
  const bool positive = !facet::points_backward(canonical.normal);
  if (!positive) canonical = {-canonical.normal, -canonical.offset};
  canonical = WholePlanes::held(canonical, unit_);
  const auto solid = static_cast<std::uint32_t>(solids_.size() - 1);
  if (const std::optional<std::uint32_t> found = find(canonical, positive)) {
    uses_[*found].last = solid;
    uses_[*found].positive = positive;
    return {*found, positive};
  }
  const auto added = static_cast<std::uint32_t>(planes_.size());
  planes_.push_back(canonical);
  uses_.push_back({solid, solid, positive});
  at_.emplace(facet::hash_of(facet::cell_of(key_of(canonical))), added);
  return {added, positive};
}

}  // namespace csgsim::software::convert
