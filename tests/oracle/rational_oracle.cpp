#include "tests/oracle/rational_oracle.h"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "tests/oracle/tree_rules.h"

namespace csgsim::testing {

namespace {

using Rational = boost::multiprecision::cpp_rational;
using Real = boost::multiprecision::cpp_bin_float_100;
using Vector = std::array<Rational, 3>;

Vector exactly(const glm::dvec3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector combine(const Vector& a, const Rational& s, const Vector& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}

/// A line; t is in model units along the view axis.
struct Ray {
  Vector origin;
  Vector direction;
};

class Eye {
 public:
  Eye(const view::Camera& camera, std::uint32_t width, std::uint32_t height)
      : perspective_(camera.projection == view::Projection::perspective), eye_(exactly(camera.eye)) {
    const Vector view = combine(exactly(camera.centre), -1, eye_);
    const Rational length = root(dot(view, view));
    Vector across = normal_of(view, exactly(camera.up));
    if (dot(across, across) == 0) across = normal_of(view, {0, 1, 0});
    const Vector upward = normal_of(across, view);
    const Real angle = boost::math::constants::pi<Real>() / 16;
    const Rational pixel = Rational(Real(2 * tan(angle) / height)) * (perspective_ ? Rational(1) : length);
    forward_ = combine({0, 0, 0}, 1 / length, view);
    right_ = combine({0, 0, 0}, pixel / root(dot(across, across)), across);
    down_ = combine({0, 0, 0}, -pixel / root(dot(upward, upward)), upward);
    middle_x_ = (Rational(width) - 1) / 2;
    middle_y_ = (Rational(height) - 1) / 2;
  }

  [[nodiscard]] Ray ray(std::uint32_t column, std::uint32_t row) const {
    const Vector aside = combine(combine({0, 0, 0}, column - middle_x_, right_), row - middle_y_, down_);
    return perspective_ ? Ray{eye_, combine(forward_, 1, aside)} : Ray{combine(eye_, 1, aside), forward_};
  }

  [[nodiscard]] bool perspective() const { return perspective_; }
  [[nodiscard]] const Vector& right() const { return right_; }
  [[nodiscard]] const Vector& down() const { return down_; }

 private:
  /// A vector perpendicular to both, to the right of the first if the second points up.
  static Vector normal_of(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  static Rational root(const Rational& square) { return Rational(Real(sqrt(Real(square)))); }

  bool perspective_;
  Vector eye_;
  Vector forward_;
  Vector right_;
  Vector down_;
  Rational middle_x_;
  Rational middle_y_;
};

/// A depth along a ray. A cut by the near plane lies before a face at the same distance.
struct Place {
  Rational t;
  bool is_face = true;

  bool operator<(const Place& other) const { return t != other.t ? t < other.t : !is_face && other.is_face; }
};

/// The interval that a solid fills: front <= z < back.
struct Interval {
  Place front;
  Place back;
};

/// The part of the ray inside a solid; empty if there is none.
std::optional<Interval> interval(const facet::Geometry& scene, const facet::Convex& solid, const Eye& eye,
                                 const Ray& ray, double near) {
  std::optional<Rational> front;
  std::optional<Rational> back;
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    const facet::Plane& plane = scene.planes.planes()[halfspace.plane];
    const Rational side = halfspace.positive ? 1 : -1;
    const Vector normal = exactly(plane.normal);
    const Rational value =
        side * (dot(normal, combine(ray.origin, -1, exactly(scene.planes.centre()))) + Rational(plane.offset));
    const Rational slope = side * dot(normal, ray.direction);
    if (slope == 0) {
      Rational outside = value;
      if (outside == 0) outside = side * dot(normal, eye.right());
      if (outside == 0) outside = side * dot(normal, eye.down());
      if (outside > 0) return std::nullopt;
      continue;
    }
    const Rational t = -value / slope;
    if (slope < 0 && (!front || t > *front)) front = t;
    if (slope > 0 && (!back || t < *back)) back = t;
  }
  Interval in{{*front}, {*back}};
  const Place cut{Rational(near), false};
  if (eye.perspective() && in.front < cut) in.front = cut;
  if (!(in.front < in.back)) return std::nullopt;
  return in;
}

}  // namespace

std::vector<std::uint32_t> rational_owners(const model::Tree& tree, const facet::Geometry& scene,
                                           const view::Camera& camera, std::uint32_t width, std::uint32_t height,
                                           double near) {
  constexpr std::uint32_t nothing = 0xffffffffU;
  std::vector<std::uint32_t> owners(static_cast<std::size_t>(width) * height, nothing);
  if (tree.root == model::no_index) return owners;
  const Eye eye(camera, width, height);
  const TreeRules rules(tree);
  const auto count = static_cast<std::uint32_t>(tree.primitives.size());
  std::vector<std::optional<Interval>> intervals(count);
  std::vector<bool> held(count);
  for (std::uint32_t pixel = 0; pixel < owners.size(); ++pixel) {
    const Ray ray = eye.ray(pixel % width, pixel / width);
    for (std::uint32_t p = 0; p < count; ++p) intervals[p] = interval(scene, scene.solids[p], eye, ray, near);
    std::optional<Place> seen;
    for (std::uint32_t p = 0; p < count; ++p) {
      if (!intervals[p]) continue;
      const Place place = rules.is_subtracted(p) ? intervals[p]->back : intervals[p]->front;
      if (seen && !(place < *seen)) continue;
      for (std::uint32_t q = 0; q < count; ++q) {
        held[q] = intervals[q] && !(place < intervals[q]->front) && place < intervals[q]->back;
      }
      if (!rules.shows(p, held)) continue;
      seen = place;
      owners[pixel] = p;
    }
  }
  return owners;
}

}  // namespace csgsim::testing
