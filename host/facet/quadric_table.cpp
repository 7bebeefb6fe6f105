#include "host/facet/quadric_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

namespace csgsim::facet {

namespace {

using Real = long double;
using Vec = glm::vec<3, Real>;
using Symmetric = std::array<Real, 6>;  // xx, yy, zz, xy, xz, yz

constexpr int max_sweeps = 60;

/// Rotates three rows until they are orthogonal: Hestenes' one-sided Jacobi method, whose relative accuracy is the same
/// for small and large rows.
std::array<Vec, 3> orthogonal_rows(const std::array<glm::dvec3, 3>& rows) {
  std::array<Vec, 3> turned{Vec(rows[0]), Vec(rows[1]), Vec(rows[2])};
  bool is_done = false;
  for (int sweep = 0; sweep < max_sweeps && !is_done; ++sweep) {
    is_done = true;
    for (const auto& [i, j] : {std::pair{0U, 1U}, {0U, 2U}, {1U, 2U}}) {
      Vec& a = turned[i];
      Vec& b = turned[j];
      const Real both = glm::dot(a, b);
      const Real lengths = glm::length(a) * glm::length(b);
      if (!(std::abs(both) > 1e-19L * lengths)) continue;
      is_done = false;
      const Real zeta = (glm::dot(b, b) - glm::dot(a, a)) / (2 * both);
      const Real t = std::copysign(1 / (std::abs(zeta) + std::hypot(Real{1}, zeta)), zeta);
      const Real c = 1 / std::hypot(Real{1}, t);
      const Vec first = c * a - c * t * b;
      b = c * t * a + c * b;
      a = first;
    }
  }
  return turned;
}

Symmetric outer(const Vec& v, Real factor) {
  return {factor * v.x * v.x, factor * v.y * v.y, factor * v.z * v.z,
          factor * v.x * v.y, factor * v.x * v.z, factor * v.y * v.z};
}

void add_to(Symmetric& sum, const Symmetric& other) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other[i];
}

/// The matrix whose eigenvectors are the directions of the rows; `of` maps the rows' lengths to the eigenvalues.
template <class Of>
Symmetric with_lengths(const std::array<Vec, 3>& rows, const Of& of) {
  Symmetric sum{};
  for (const Vec& row : rows) {
    const Real length = glm::length(row);
    if (length > 0) add_to(sum, outer(row / length, of(length)));
  }
  return sum;
}

Symmetric make_form(const Quadric& quadric) {
  Symmetric form{};
  for (std::size_t i = 0; i < 3; ++i) {
    add_to(form, outer(Vec(quadric.to_unit[i]), static_cast<Real>(quadric.signs()[i])));
  }
  return form;
}

/// Eigenvectors as columns, and eigenvalues, by Jacobi's method.
struct Eigen {
  std::array<Vec, 3> vectors{Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1)};
  std::array<Real, 3> values{};
};

Eigen solve_eigen(const Symmetric& form) {
  std::array<std::array<Real, 3>, 3> m{
      {{form[0], form[3], form[4]}, {form[3], form[1], form[5]}, {form[4], form[5], form[2]}}};
  Eigen eigen;
  bool is_done = false;
  for (int sweep = 0; sweep < max_sweeps && !is_done; ++sweep) {
    is_done = true;
    for (const auto& [p, q] : {std::pair{0U, 1U}, {0U, 2U}, {1U, 2U}}) {
      // Iterates to the maximum accuracy relative to the smaller of the two diagonal entries.
      if (!(std::abs(m[p][q]) > 1e-19L * std::sqrt(std::abs(m[p][p] * m[q][q]))) || m[p][q] == 0) continue;
      const Real theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const Real t = std::copysign(1 / (std::abs(theta) + std::hypot(Real{1}, theta)), theta);
      const Real c = 1 / std::hypot(Real{1}, t);
      const Real s = t * c;
      is_done = false;
      for (std::size_t k = 0; k < 3; ++k) {
        const Real kp = m[k][p];
        m[k][p] = c * kp - s * m[k][q];
        m[k][q] = s * kp + c * m[k][q];
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const Real pk = m[p][k];
        m[p][k] = c * pk - s * m[q][k];
        m[q][k] = s * pk + c * m[q][k];
      }
      const Vec vp = eigen.vectors[p];
      eigen.vectors[p] = c * vp - s * eigen.vectors[q];
      eigen.vectors[q] = s * vp + c * eigen.vectors[q];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) eigen.values[k] = m[k][k];
  return eigen;
}

/// A cone about its principal axis, the eigenvector of its only negative eigenvalue.
struct PrincipalCone {
  Vec axis{0, 0, 1};
  /// Matrix whose eigenvalues are the angles between the axis and the sides, in radians.
  Symmetric angles{};
  Real sine = 0;  ///< square root of the sum of the squares of the sines of these angles
};

PrincipalCone principal(const Symmetric& form) {
  const Eigen eigen = solve_eigen(form);
  const auto lowest = std::min_element(eigen.values.begin(), eigen.values.end()) - eigen.values.begin();
  const auto inner = static_cast<std::size_t>(lowest);
  PrincipalCone cone;
  cone.axis = glm::normalize(eigen.vectors[inner]);
  const Real depth = std::sqrt(std::max(Real{0}, -eigen.values[inner]));
  Real squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == inner) continue;
    const Real angle = std::atan2(depth, std::sqrt(std::max(Real{0}, eigen.values[i])));
    add_to(cone.angles, outer(glm::normalize(eigen.vectors[i]), angle));
    squares += std::sin(angle) * std::sin(angle);
  }
  cone.sine = std::sqrt(squares);
  return cone;
}

/// Scales the quadric so that the largest entry of the form has magnitude 1; this does not change the cone.
void normalise_cone(Quadric& quadric) {
  const Symmetric form = make_form(quadric);
  Real most = 0;
  for (const Real entry : form) most = std::max(most, std::abs(entry));
  const Real factor = 1 / std::sqrt(most);
  for (glm::dvec3& row : quadric.to_unit) row = glm::dvec3(Vec(row) * factor);
}

/// The canonical axis of a cylinder or cone.
glm::dvec3 canonical_axis(const Quadric& quadric) {
  glm::dvec3 axis(0, 0, 1);
  if (quadric.kind == QuadricKind::cylinder) {
    const std::array<Vec, 3> rows = orthogonal_rows(quadric.to_unit);
    axis = glm::dvec3(glm::normalize(glm::cross(glm::normalize(rows[0]), glm::normalize(rows[1]))));
  } else if (quadric.kind == QuadricKind::cone) {
    axis = glm::dvec3(principal(make_form(quadric)).axis);
  }
  return points_backward(axis) ? -axis : axis;
}

Vec nearest_to_zero(const glm::dvec3& point, const glm::dvec3& axis) {
  const Vec from(point);
  const Vec along(axis);
  return from - along * (glm::dot(from, along) / glm::dot(along, along));
}

}  // namespace

QuadricTable::QuadricTable(const glm::dvec3& centre, double diagonal)
    : centre_(centre), diagonal_(diagonal > 0.0 ? diagonal : 1.0) {}

/// The key consists of quantities that change as much as the surface does. Ellipsoid: half axes and centre. Cylinder:
/// half axes across the axis, and the axis's position. Cone: angles, the axis and its position, and the distance of
/// that position from the sides.
QuadricTable::Known QuadricTable::make_key(const Quadric& canonical) const {
  Vec place(canonical.origin);
  Vec axis(0);
  Symmetric shape{};
  Real from_sides = 0;
  if (canonical.kind == QuadricKind::cone) {
    const PrincipalCone cone = principal(make_form(canonical));
    axis = Vec(canonical.axis);
    shape = cone.angles;
    place = nearest_to_zero(canonical.origin, canonical.axis);
    from_sides = glm::dot(Vec(canonical.origin) - place, axis) * cone.sine / static_cast<Real>(diagonal_);
  } else {
    if (canonical.kind == QuadricKind::cylinder) axis = Vec(canonical.axis);
    shape = with_lengths(orthogonal_rows(canonical.to_unit),
                         [&](Real length) { return 1 / (length * static_cast<Real>(diagonal_)); });
  }
  place /= static_cast<Real>(diagonal_);
  Known key{};
  for (int i = 0; i < 3; ++i) {
    key[static_cast<std::size_t>(i)] = static_cast<double>(place[i]);
    key[static_cast<std::size_t>(i) + 3] = static_cast<double>(axis[i]);
  }
  for (std::size_t i = 0; i < shape.size(); ++i) key[6 + i] = static_cast<double>(shape[i]);
  key[12] = static_cast<double>(from_sides);
  return key;
}

/// The first quadric that coincides with the given one.
std::optional<std::uint32_t> QuadricTable::find(const Known& key, QuadricKind kind) const {
  std::optional<std::uint32_t> first;
  for_each_near_cell(key, [&](const Known& cell) {
    const auto found = at_.find(hash_of(cell));
    if (found == at_.end()) return;
    for (const std::uint32_t one : found->second) {
      if (quadrics_[one].kind == kind && are_near(key, keys_[one])) first = std::min(first.value_or(one), one);
    }
  });
  return first;
}

QuadricSide QuadricTable::add(const Quadric& quadric, const glm::dvec3& inward) {
  Quadric canonical = quadric;
  if (quadric.kind == QuadricKind::cone) normalise_cone(canonical);
  const Symmetric form = make_form(canonical);
  for (std::size_t i = 0; i < form.size(); ++i) canonical.form[i] = static_cast<double>(form[i]);
  canonical.axis = canonical_axis(canonical);
  canonical.origin -= centre_;
  if (quadric.kind == QuadricKind::cylinder)
    canonical.origin = glm::dvec3(nearest_to_zero(canonical.origin, canonical.axis));
  // The axis is principal, so all directions inside one nappe have components of the same sign along it.
  const auto along = [&](const glm::dvec3& axis) {
    return quadric.kind != QuadricKind::cone || glm::dot(inward, axis) > 0.0;
  };
  const Known key = make_key(canonical);
  if (const std::optional<std::uint32_t> found = find(key, quadric.kind))
    return {*found, along(quadrics_[*found].axis)};
  const auto added = static_cast<std::uint32_t>(quadrics_.size());
  quadrics_.push_back(canonical);
  keys_.push_back(key);
  at_[hash_of(cell_of(key))].push_back(added);
  return {added, along(canonical.axis)};
}

}  // namespace csgsim::facet
