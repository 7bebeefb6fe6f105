#pragma once

#include <rapidcheck.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>
#include <variant>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/isa/depth_scale.h"

namespace csgsim::test {

using Real = boost::multiprecision::cpp_bin_float_100;
using Vec = std::array<Real, 3>;

inline double real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }
inline glm::dvec3 vector(int low, int high) { return {real(low, high), real(low, high), real(low, high)}; }

inline glm::dmat4 turn_about(int axis, double angle) {
  glm::dmat4 turn(1.0);
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  turn[i][i] = turn[j][j] = std::cos(angle);
  turn[i][j] = std::sin(angle);
  turn[j][i] = -std::sin(angle);
  return turn;
}

inline glm::dmat4 random_rotation() {
  return turn_about(0, real(-4, 4)) * turn_about(1, real(-4, 4)) * turn_about(2, real(-4, 4));
}

inline glm::dmat4 scaling(const glm::dvec3& by) {
  glm::dmat4 matrix(1.0);
  for (int i = 0; i < 3; ++i) matrix[i][i] = by[i];
  return matrix;
}

inline glm::dmat4 shift(const glm::dvec3& by) {
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(by, 1.0);
  return matrix;
}

inline model::Tree single(model::Shape shape, const glm::dmat4& place) {
  model::Tree tree;
  tree.primitives.push_back({std::move(shape), place, std::nullopt, {}});
  tree.nodes.push_back({true, model::Operator::unite, 0, {}});
  tree.root = 0;
  return tree;
}

inline facet::Faceting exact() {
  facet::Faceting faceting;
  faceting.exact_curves = true;
  return faceting;
}

struct Subject {
  model::Tree tree;
  view::Camera camera;
  view::Sampling sampling;
};

/// Shapes of many sizes and places, seen from outside and inside, from far and near, with few and many bits.
inline Subject random_subject() {
  const double size = std::pow(10.0, real(-3, 3));
  const glm::dvec3 squeeze(std::pow(10.0, real(-1, 1)), std::pow(10.0, real(-1, 1)), 1.0);
  const glm::dvec3 far_off = *rc::gen::arbitrary<bool>() ? glm::dvec3(0) : vector(-5000, 5000) * size;
  const glm::dmat4 place = shift(far_off) * random_rotation() * scaling(size * squeeze);
  const bool is_uniform = *rc::gen::arbitrary<bool>();
  const glm::dmat4 used = is_uniform ? shift(far_off) * random_rotation() * scaling(glm::dvec3(size)) : place;
  Subject subject;
  const int kind = *rc::gen::inRange(0, 3);
  const double r1 = real(0, 4);
  const double r2 = kind == 1 ? r1 + 0.001 : *rc::gen::element(0.0, real(1, 4), 5.0 * r1 + 1.0);
  if (kind == 0) {
    subject.tree = single(model::Sphere{real(1, 4), {}}, used);
  } else {
    subject.tree = single(
        model::Cylinder{real(1, 9), kind == 1 ? r2 : r1, r1 + r2 > 0 ? r2 : 1.0, *rc::gen::arbitrary<bool>(), {}},
        used);
  }
  const double distance = *rc::gen::element(1.0, 3.0, 30.0, 1000.0);
  const glm::dvec3 back = glm::normalize(vector(-4, 4) + glm::dvec3(0.0005));
  const glm::dvec3 look = far_off + size * vector(-2, 2);
  subject.camera = {look + size * distance * back, look,
                    *rc::gen::arbitrary<bool>() ? view::Projection::perspective : view::Projection::orthographic};
  if (*rc::gen::arbitrary<bool>() && subject.camera.projection == view::Projection::orthographic)
    subject.camera.eye = look + size * 30.0 * back;
  subject.sampling.width = static_cast<std::uint32_t>(*rc::gen::inRange(8, 48));
  subject.sampling.height = static_cast<std::uint32_t>(*rc::gen::inRange(8, 48));
  subject.sampling.z_bits = static_cast<unsigned>(*rc::gen::inRange(6, 25));
  subject.sampling.fraction_bits = static_cast<unsigned>(*rc::gen::inRange(6, 16));
  subject.sampling.offset = {real(-1, 1) / 2.0, real(-1, 1) / 2.0};
  return subject;
}

/// A shape in its own space, met by the ray of a pixel at start + distance * direction: a t^2 + 2 b t + c <= 0.
struct Met {
  Real a = 0;
  Real b = 0;
  Real c = 0;
  Vec start;  // in the shape's space
  Vec direction;
};

inline Vec own_space(const glm::dmat4& m, const Vec& v) {
  const auto minor = [&](int i, int j, int k, int l) { return Real(m[i][j]) * m[k][l] - Real(m[k][j]) * m[i][l]; };
  const Real determinant =
      Real(m[0][0]) * minor(1, 1, 2, 2) - Real(m[1][0]) * minor(0, 1, 2, 2) + Real(m[2][0]) * minor(0, 1, 1, 2);
  // Cramer's rule.
  Vec out;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const auto cross = [&](int row) {
      const int p = (row + 1) % 3;
      const int q = (row + 2) % 3;
      return Real(m[j][p]) * m[k][q] - Real(m[j][q]) * m[k][p];
    };
    out[static_cast<std::size_t>(i)] = (cross(0) * v[0] + cross(1) * v[1] + cross(2) * v[2]) / determinant;
  }
  return out;
}

struct Ray {
  Vec start;
  Vec direction;
};

/// The ray of a pixel in model space relative to an origin.
inline Ray ray_of(const view::EyeSpace& space, double x, double y, const Vec& origin) {
  const Real right = (Real(x) - space.middle_x) * space.pixel;
  const Real up = (Real(space.middle_y) - y) * space.pixel;
  Ray ray;
  for (int i = 0; i < 3; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const Real across = right * space.axes.right[i] + up * space.axes.up[i];
    ray.direction[n] = Real(space.axes.forward[i]) + (space.perspective ? across : Real(0));
    ray.start[n] = Real(space.eye[i]) - origin[n] + (space.perspective ? Real(0) : across);
  }
  return ray;
}

/// The scene's quadric itself, with its doubles taken as exact.
inline Met meet(const facet::Quadric& quadric, const glm::dvec3& centre, const view::EyeSpace& space, double x,
                double y) {
  const Ray ray =
      ray_of(space, x, y,
             {Real(centre.x) + quadric.origin.x, Real(centre.y) + quadric.origin.y, Real(centre.z) + quadric.origin.z});
  Met met;
  met.c = quadric.level();
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& row = quadric.to_unit[i];
    const Real from = row.x * ray.start[0] + row.y * ray.start[1] + row.z * ray.start[2];
    const Real along = row.x * ray.direction[0] + row.y * ray.direction[1] + row.z * ray.direction[2];
    met.a += quadric.signs()[i] * along * along;
    met.b += quadric.signs()[i] * from * along;
    met.c += quadric.signs()[i] * from * from;
  }
  return met;
}

inline Met meet(const Subject& subject, double x, double y) {
  const model::Primitive& primitive = subject.tree.primitives[0];
  const glm::dvec4& place = primitive.transform[3];
  const Ray ray = ray_of(view::eye_space(subject.camera, subject.sampling), x, y, {place.x, place.y, place.z});
  Met met;
  met.start = own_space(primitive.transform, ray.start);
  met.direction = own_space(primitive.transform, ray.direction);
  const auto add = [&](std::size_t axis, const Real& sign, const Real& from) {
    met.a += sign * met.direction[axis] * met.direction[axis];
    met.b += sign * met.direction[axis] * (met.start[axis] - from);
    met.c += sign * (met.start[axis] - from) * (met.start[axis] - from);
  };
  add(0, 1, 0);
  add(1, 1, 0);
  if (const auto* sphere = std::get_if<model::Sphere>(&primitive.shape)) {
    add(2, 1, 0);
    met.c -= Real(sphere->radius) * sphere->radius;
    return met;
  }
  const auto& cylinder = std::get<model::Cylinder>(primitive.shape);
  if (cylinder.r1 == cylinder.r2) {
    met.c -= Real(cylinder.r1) * cylinder.r1;
    return met;
  }
  const Real low = cylinder.center ? -cylinder.height / 2 : 0.0;
  const Real rise = Real(cylinder.r1) - cylinder.r2;
  add(2, -(rise / cylinder.height) * (rise / cylinder.height), low + cylinder.height * Real(cylinder.r1) / rise);
  return met;
}

/// Middle and discriminant in depth steps; nothing if the coefficient of the depth's square is 0.
struct Truth {
  Real middle;
  Real discriminant;
};

inline Truth truth_of(const view::View& view, const Met& met) {
  const Real near = view.depth.near;
  const Real far = view.depth.far;
  const Real steps = isa::depth_steps(view.sampling.z_bits);
  const Real root = met.b * met.b - met.a * met.c;
  if (view.depth.perspective) {
    const Real scale = steps / (1 / near - 1 / far);
    return {1 + (1 / near + met.b / met.c) * scale, root / (met.c * met.c) * scale * scale};
  }
  const Real scale = steps / (far - near);
  return {1 + (-met.b / met.a - near) * scale, root / (met.a * met.a) * scale * scale};
}

inline Real distance_at(const view::View& view, double depth) {
  const Real near = view.depth.near;
  const Real far = view.depth.far;
  const Real part = (Real(depth) - 1) / isa::depth_steps(view.sampling.z_bits);
  if (view.depth.perspective) return 1 / (1 / near - part * (1 / near - 1 / far));
  return near + part * (far - near);
}

/// Whether a place on a ray is in the shape, including its planes.
inline bool is_in(const Subject& subject, const Met& met, const Real& distance) {
  const model::Primitive& primitive = subject.tree.primitives[0];
  const auto at = [&](std::size_t axis) -> Real { return met.start[axis] + distance * met.direction[axis]; };
  if ((met.a * distance + 2 * met.b) * distance + met.c > 0) return false;
  const auto* cylinder = std::get_if<model::Cylinder>(&primitive.shape);
  if (cylinder == nullptr) return true;
  const double low = cylinder->center ? -cylinder->height / 2 : 0.0;
  return at(2) >= low && at(2) <= low + cylinder->height;
}

inline glm::dmat4 rotated_by_a_third() { return turn_about(0, 1.0 / 3) * turn_about(1, 1.0 / 3); }

inline bool representable(const view::View& view) {
  return std::all_of(view.planes.begin(), view.planes.end(),
                     [](const view::ScreenPlane& plane) { return plane.representable; });
}

}  // namespace csgsim::test
