#include "sim/judges/solid_ray.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace csgsim::judges {

namespace {

constexpr long double endless = std::numeric_limits<long double>::infinity();
constexpr Interval everywhere{-endless, endless};
constexpr Interval nowhere{endless, -endless};

Interval common(const Interval& a, const Interval& b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

/// The interval of t with slope t + value <= 0.
Interval below_zero(long double slope, long double value) {
  if (slope == 0) return value < 0 ? everywhere : nowhere;
  const long double root = -value / slope;
  return slope > 0 ? Interval{-endless, root} : Interval{root, endless};
}

Interval slab(long double low, long double high, long double origin, long double direction) {
  return common(below_zero(-direction, low - origin), below_zero(direction, origin - high));
}

/// The interval of t in `within` with a t^2 + 2 b t + c <= 0; the longer one if a < 0 and there are two.
Interval below_zero(long double a, long double b, long double c, const Interval& within) {
  const long double discriminant = b * b - a * c;
  if (a == 0) return common(below_zero(2 * b, c), within);
  if (discriminant < 0) return a > 0 ? nowhere : within;
  // Computes the root without cancellation first, and the other from the product of both.
  const long double sum = -(b + std::copysign(std::sqrt(discriminant), b));
  const auto [low, high] = std::minmax({sum / a, sum != 0 ? c / sum : 0.0L});
  if (a > 0) return common({low, high}, within);
  const Interval before = common({-endless, low}, within);
  const Interval behind = common({high, endless}, within);
  return before.high - before.low > behind.high - behind.low ? before : behind;
}

struct Extent {
  LongVector low;
  LongVector high;
};

struct MeasureExtent {
  Extent operator()(const model::Cube& shape) const {
    const LongVector size(shape.size);
    const LongVector low = shape.center ? -size / 2.0L : LongVector(0);
    return {low, low + size};
  }
  Extent operator()(const model::Sphere& shape) const { return {LongVector(-shape.radius), LongVector(shape.radius)}; }
  Extent operator()(const model::Cylinder& shape) const {
    const long double radius = std::max(shape.r1, shape.r2);
    const long double foot = shape.center ? -static_cast<long double>(shape.height) / 2 : 0;
    return {{-radius, -radius, foot}, {radius, radius, foot + shape.height}};
  }
  Extent operator()(const model::Polyhedron& shape) const {
    Extent extent{LongVector(shape.points.front()), LongVector(shape.points.front())};
    for (const glm::dvec3& point : shape.points) {
      extent = {glm::min(extent.low, LongVector(point)), glm::max(extent.high, LongVector(point))};
    }
    return extent;
  }
};

/// The polygon's normal with twice its area as length (Newell), relative to its first corner.
LongVector newell(const model::Polyhedron& shape, const std::vector<std::uint32_t>& face) {
  LongVector normal(0);
  const LongVector first(shape.points[face.front()]);
  for (std::size_t i = 0; i < face.size(); ++i) {
    const LongVector here(shape.points[face[i]]);
    const LongVector next(shape.points[face[(i + 1) % face.size()]]);
    normal += glm::cross(here - first, next - first);
  }
  return normal;
}

}  // namespace

TrueSolid::TrueSolid(const model::Primitive& primitive)
    : primitive_(primitive), to_model_(primitive.transform), to_object_(glm::inverse(to_model_)) {
  const Extent extent = std::visit(MeasureExtent{}, primitive.shape);
  low_ = extent.low;
  high_ = extent.high;
  const auto* shape = std::get_if<model::Polyhedron>(&primitive.shape);
  if (shape == nullptr) return;
  // A point that is certainly inside, unlike the centre of the bounding box.
  LongVector inside(0);
  for (const glm::dvec3& point : shape->points) inside += LongVector(point);
  inside /= static_cast<long double>(shape->points.size());
  for (const std::vector<std::uint32_t>& face : shape->faces) {
    Side side{newell(*shape, face), 0};
    LongVector centroid(0);
    for (const std::uint32_t corner : face) centroid += LongVector(shape->points[corner]);
    centroid /= static_cast<long double>(face.size());
    side.offset = -glm::dot(side.normal, centroid);
    // Orients the normal outwards, for either order of the corners.
    if (glm::dot(side.normal, inside) + side.offset > 0) side = {-side.normal, -side.offset};
    sides_.push_back(side);
  }
}

Interval TrueSolid::on(const Line& line) const {
  Line local{LongVector(to_object_ * glm::vec<4, long double>(line.origin, 1.0L)),
             LongVector(to_object_ * glm::vec<4, long double>(line.direction, 0.0L))};
  // Shifts the origin to the point nearest to the middle of the solid, which avoids cancellation.
  const LongVector middle = (low_ + high_) / 2.0L;
  const long double shift =
      glm::dot(middle - local.origin, local.direction) / glm::dot(local.direction, local.direction);
  local.origin += shift * local.direction;
  const Interval in = std::visit([&](const auto& shape) { return within(shape, local); }, primitive_.shape);
  return {in.low + shift, in.high + shift};
}

Interval TrueSolid::within(const model::Cube& /*shape*/, const Line& line) const {
  Interval in = everywhere;
  for (int axis = 0; axis < 3; ++axis) {
    in = common(in, slab(low_[axis], high_[axis], line.origin[axis], line.direction[axis]));
  }
  return in;
}

Interval TrueSolid::within(const model::Sphere& shape, const Line& line) {
  const long double radius = shape.radius;
  const LongVector& o = line.origin;
  const LongVector& d = line.direction;
  return below_zero(glm::dot(d, d), glm::dot(o, d), glm::dot(o, o) - radius * radius, everywhere);
}

/// x^2 + y^2 <= r(z)^2 between the ends, where r is linear and not negative.
Interval TrueSolid::within(const model::Cylinder& shape, const Line& line) {
  const LongVector& o = line.origin;
  const LongVector& d = line.direction;
  const long double height = shape.height;
  const long double foot = shape.center ? -height / 2 : 0;
  const Interval between = slab(foot, foot + height, o.z, d.z);
  if (between.empty()) return nowhere;
  const long double taper = (static_cast<long double>(shape.r2) - shape.r1) / height;
  const long double radius = shape.r1 + taper * (o.z - foot);  // at the line's origin
  const long double slope = taper * d.z;
  return below_zero(d.x * d.x + d.y * d.y - slope * slope, o.x * d.x + o.y * d.y - radius * slope,
                    o.x * o.x + o.y * o.y - radius * radius, between);
}

Interval TrueSolid::within(const model::Polyhedron& /*shape*/, const Line& line) const {
  Interval in = everywhere;
  for (const Side& side : sides_) {
    in =
        common(in, below_zero(glm::dot(side.normal, line.direction), glm::dot(side.normal, line.origin) + side.offset));
  }
  return in;
}

std::vector<LongVector> TrueSolid::corners() const {
  std::vector<LongVector> all;
  for (unsigned i = 0; i < 8; ++i) {
    const LongVector corner((i & 1U) != 0 ? high_.x : low_.x, (i & 2U) != 0 ? high_.y : low_.y,
                            (i & 4U) != 0 ? high_.z : low_.z);
    all.emplace_back(to_model_ * glm::vec<4, long double>(corner, 1.0L));
  }
  return all;
}

}  // namespace csgsim::judges
