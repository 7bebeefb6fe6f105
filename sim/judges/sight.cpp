#include "sim/judges/sight.h"

#include <cmath>
#include <limits>

#include "hw/isa/depth_scale.h"

namespace csgsim::judges {

namespace {

/// Bound of the rounding error of three coefficients, two products and two sums, relative to the sum of magnitudes.
constexpr double filter_part = 0x1p-49;

}  // namespace

Sight::Sight(const facet::Geometry& geometry, const view::Camera& camera, std::uint32_t width, std::uint32_t height,
             const isa::DepthScale& depth)
    : table_(geometry.planes),
      camera_(camera, width, height, depth),
      from_middle_(camera_.eye - to_exact(geometry.planes.centre())),
      quadrics_(geometry.quadrics, camera_),
      unit_(camera_.axis_length.to_double()) {
  const auto count = static_cast<std::uint32_t>(table_.planes().size()) + 2;
  planes_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) planes_[i] = make_filter(i);
}

Sight::Exact Sight::make_exact(std::uint32_t index) const {
  // q = -|v| / near.
  if (index == near_plane()) return {{-camera_.axis_length, Dyadic(), Dyadic()}, camera_.near};
  if (index == horizon()) return {{}, Dyadic(-1.0)};
  const facet::Plane& plane = table_.planes()[index];
  const Vector normal = to_exact(plane.normal);
  const Dyadic at_eye = dot(normal, from_middle_) + Dyadic(plane.offset);
  const Dyadic along = dot(normal, camera_.forward);
  // The plane's equation on the ray eye + t v, shifted or rotated by the pixel's place, is at_eye + t * along <= 0.
  Exact exact{{at_eye, dot(normal, camera_.right) * camera_.right_step, -(dot(normal, camera_.up) * camera_.up_step)},
              -along};
  if (is_perspective()) {
    exact.l.l0 = along;
    exact.k = at_eye;
  }
  return exact;
}

const Sight::Exact& Sight::exact(std::uint32_t index) const {
  const auto [kept, is_new] = kept_.try_emplace(index);
  if (is_new) kept->second = make_exact(index);
  return kept->second;
}

/// Sum of the magnitudes of the terms of a plane's denominator k.
double Sight::denominator_size(std::uint32_t index) const {
  if (index >= near_plane()) return std::abs(make_exact(index).k.to_double());
  const facet::Plane& plane = table_.planes()[index];
  const Vector& factor = is_perspective() ? from_middle_ : camera_.forward;
  double size = is_perspective() ? std::abs(plane.offset) : 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    size += std::abs(plane.normal[axis] * factor[static_cast<std::size_t>(axis)].to_double());
  }
  return size;
}

SightPlane Sight::make_filter(std::uint32_t index) const {
  const Exact exact = make_exact(index);
  SightPlane plane;
  double k = exact.k.to_double();
  if (exact.k.sign() != 0) plane.role = exact.k.sign() > 0 ? Role::front : Role::back;
  plane.condition = denominator_size(index) / std::abs(k);
  if (plane.role == Role::edge) k = plane.condition = 1.0;
  plane.c = exact.l.l0.to_double() / k;
  plane.a = exact.l.lx.to_double() / k;
  plane.b = exact.l.ly.to_double() / k;
  plane.error =
      filter_part * (std::abs(plane.c) + std::abs(plane.a) * camera_.width + std::abs(plane.b) * camera_.height) +
      std::numeric_limits<double>::min();
  if (!std::isfinite(plane.error) || std::abs(k) < std::numeric_limits<double>::min()) {
    plane = {0, 0, 0, infinity, infinity, plane.role};
  }
  return plane;
}

int Sight::compare_exactly(std::uint32_t first, std::uint32_t second, Place place) const {
  const Exact& one = exact(first);
  const Exact& other = exact(second);
  const int sign = (one.l.at(place) * other.k - other.l.at(place) * one.k).sign();
  if (sign == 0 && first == near_plane()) return -1;
  if (sign == 0 && second == near_plane()) return 1;
  return one.k.sign() == other.k.sign() ? sign : -sign;
}

bool Sight::edge_contains_ray(std::uint32_t index, Place place) const {
  const double value = planes_[index].at(place);
  if (std::abs(value) > planes_[index].error) return value < 0.0;
  const Exact& line = exact(index);
  int sign = line.l.at(place).sign();
  if (sign == 0) sign = line.l.lx.sign();
  if (sign == 0) sign = line.l.ly.sign();
  return sign < 0;
}

Estimate Sight::estimate_depth(Sheet sheet, Place place) const {
  if (sheet.root != Root::only) return quadrics_.estimate_depth(sheet, place);
  const SightPlane& plane = planes_[sheet.index];
  return {plane.at(place), 2.0 * plane.error};
}

Surd Sight::exact_depth(Sheet sheet, Place place) const {
  if (sheet.root != Root::only) return quadrics_.exact_depth(sheet, place);
  const Exact& plane = exact(sheet.index);
  return {plane.l.at(place), 0, {}, plane.k};
}

int Sight::compare_with_roots(Sheet first, Sheet second, Place place) const {
  if (first == second) return 0;
  const Estimate a = estimate_depth(first, place);
  const Estimate b = estimate_depth(second, place);
  const double difference = a.value - b.value;
  if (std::abs(difference) > a.error + b.error) return difference > 0.0 ? 1 : -1;
  const int sign = judges::compare(exact_depth(first, place), exact_depth(second, place));
  const Sheet near{near_plane(), Root::only};
  if (sign == 0 && first == near) return -1;
  if (sign == 0 && second == near) return 1;
  return sign;
}

double Sight::distance(Sheet sheet, Place place) const {
  // The coefficients of steep surfaces cancel; their depth is then computed from the exact numbers.
  Estimate depth = estimate_depth(sheet, place);
  const bool fine = depth.error <= 0x1p-45 * std::abs(depth.value);
  if (!fine) depth.value = static_cast<double>(exact_depth(sheet, place).to_real());
  return is_perspective() ? -unit_ / depth.value : unit_ * depth.value;
}

}  // namespace csgsim::judges
