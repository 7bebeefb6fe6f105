#include "sim/judges/sight.h"

#include <cmath>
#include <limits>

namespace csgsim::judges {

namespace {

/// tan(180/16 degrees).
Real tangent_of_half_field() {
  const Real root = sqrt(Real(2));
  return sqrt(4 + 2 * root) - root - 1;
}

/// Nearer to the camera's upward direction than this (sine of the angle) a view has +y upwards.
constexpr double along_up = 1e-12;

/// Rounding of three coefficients, two products and two sums stays below this part of the sum of their sizes.
constexpr double filter_part = 0x1p-49;

}  // namespace

Dyadic Sight::Exact::numerator(Place place) const {
  return l0 + Dyadic(static_cast<double>(place.x)) * lx + Dyadic(static_cast<double>(place.y)) * ly;
}

Sight::Sight(const facet::PlaneTable& planes, const view::Camera& camera, std::uint32_t width, std::uint32_t height,
             const isa::DepthScale& depth)
    : table_(planes),
      perspective_(camera.projection == view::Projection::perspective),
      width_(width),
      height_(height),
      from_middle_(exactly(camera.eye) - exactly(planes.centre())),
      forward_(exactly(camera.centre) - exactly(camera.eye)),
      near_(perspective_ ? depth.near : 1.0) {
  const Real length = sqrt(dot(forward_, forward_).to_real());
  right_ = cross(forward_, exactly(camera.up));
  if (sqrt(dot(right_, right_).to_real()) <= along_up * length) right_ = cross(forward_, exactly({0, 1, 0}));
  up_ = cross(right_, forward_);
  const Real half_pixel = tangent_of_half_field() * length / height;
  right_step_ = Dyadic(Real(half_pixel / sqrt(dot(right_, right_).to_real())));
  up_step_ = Dyadic(Real(half_pixel / sqrt(dot(up_, up_).to_real())));
  axis_length_ = Dyadic(length);
  unit_ = axis_length_.approximately();
  const auto count = static_cast<std::uint32_t>(planes.planes().size());
  planes_.resize(count + 1);
  for (std::uint32_t i = 0; i <= count; ++i) planes_[i] = make_filter(i);
}

Sight::Exact Sight::make_exact(std::uint32_t index) const {
  // q = -|v| / near.
  if (index >= table_.planes().size()) return {-axis_length_, Dyadic(), Dyadic(), near_};
  const facet::Plane& plane = table_.planes()[index];
  const Vector normal = exactly(plane.normal);
  const Dyadic at_eye = dot(normal, from_middle_) + Dyadic(plane.offset);
  const Dyadic along = dot(normal, forward_);
  // On the ray eye + t v, moved or turned by the pixel's place, the plane's equation is at_eye + t * along <= 0.
  Exact exact{at_eye, dot(normal, right_) * right_step_, -(dot(normal, up_) * up_step_), -along};
  if (perspective_) {
    exact.l0 = along;
    exact.k = at_eye;
  }
  return exact;
}

const Sight::Exact& Sight::exact(std::uint32_t index) const {
  const auto found = kept_.find(index);
  if (found != kept_.end()) return found->second;
  return kept_.emplace(index, make_exact(index)).first->second;
}

/// Sum of the sizes of the terms that the denominator k of a plane is summed from.
double Sight::denominator_size(std::uint32_t index) const {
  if (index >= table_.planes().size()) return near_.approximately();
  const facet::Plane& plane = table_.planes()[index];
  const Vector& factor = perspective_ ? from_middle_ : forward_;
  double size = perspective_ ? std::abs(plane.offset) : 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    size += std::abs(plane.normal[axis] * factor[static_cast<std::size_t>(axis)].approximately());
  }
  return size;
}

SightPlane Sight::make_filter(std::uint32_t index) const {
  const Exact exact = make_exact(index);
  SightPlane plane;
  double k = exact.k.approximately();
  if (exact.k.sign() != 0) plane.role = exact.k.sign() > 0 ? Role::front : Role::back;
  plane.condition = denominator_size(index) / std::abs(k);
  if (plane.role == Role::edge) k = plane.condition = 1.0;
  plane.c = exact.l0.approximately() / k;
  plane.a = exact.lx.approximately() / k;
  plane.b = exact.ly.approximately() / k;
  plane.error = filter_part * (std::abs(plane.c) + std::abs(plane.a) * width_ + std::abs(plane.b) * height_) +
                std::numeric_limits<double>::min();
  if (!std::isfinite(plane.error) || std::abs(k) < std::numeric_limits<double>::min()) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    plane = {0, 0, 0, infinity, infinity, plane.role};
  }
  return plane;
}

int Sight::compare(std::uint32_t first, std::uint32_t second, Place place) const {
  if (first == second) return 0;
  const SightPlane& a = planes_[first];
  const SightPlane& b = planes_[second];
  const double difference = a.at(place) - b.at(place);
  if (std::abs(difference) > 2.0 * (a.error + b.error)) return difference > 0.0 ? 1 : -1;
  const Exact& one = exact(first);
  const Exact& other = exact(second);
  const int sign = (one.numerator(place) * other.k - other.numerator(place) * one.k).sign();
  if (sign == 0 && first == near_plane()) return -1;
  if (sign == 0 && second == near_plane()) return 1;
  return one.k.sign() == other.k.sign() ? sign : -sign;
}

bool Sight::edge_holds(std::uint32_t index, Place place) const {
  const double value = planes_[index].at(place);
  if (std::abs(value) > planes_[index].error) return value < 0.0;
  const Exact& line = exact(index);
  int sign = line.numerator(place).sign();
  if (sign == 0) sign = line.lx.sign();
  if (sign == 0) sign = line.ly.sign();
  return sign < 0;
}

double Sight::distance(std::uint32_t index, Place place) const {
  const SightPlane& plane = planes_[index];
  const double filtered = plane.at(place);
  // A steep plane's coefficients cancel: its depth is worked out from the exact numbers then.
  const bool fine = plane.error <= 0x1p-46 * std::abs(filtered);
  double depth = filtered;
  if (!fine) {
    const Exact& line = exact(index);
    depth = line.numerator(place).approximately() / line.k.approximately();
  }
  return perspective_ ? -unit_ / depth : unit_ * depth;
}

}  // namespace csgsim::judges
