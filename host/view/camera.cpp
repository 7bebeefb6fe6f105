#include "host/view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "host/model/degrees.h"
#include "hw/base/error.h"

namespace csgsim::view {

namespace {

constexpr double half_field_of_view = 11.25 * std::numbers::pi / 180.0;

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Rotates about x, then y, then z.
glm::dvec3 turned_about_axes(const glm::dvec3& v, const glm::dvec3& degrees) {
  const glm::dvec3 s(model::sin_degrees(degrees.x), model::sin_degrees(degrees.y), model::sin_degrees(degrees.z));
  const glm::dvec3 c(model::cos_degrees(degrees.x), model::cos_degrees(degrees.y), model::cos_degrees(degrees.z));
  const glm::dvec3 x(v.x, c.x * v.y - s.x * v.z, s.x * v.y + c.x * v.z);
  const glm::dvec3 y(c.y * x.x + s.y * x.z, x.y, c.y * x.z - s.y * x.x);
  return {c.z * y.x - s.z * y.y, s.z * y.x + c.z * y.y, y.z};
}

}  // namespace

Camera gimbal_camera(const glm::dvec3& centre, const glm::dvec3& degrees, double distance) {
  const glm::dvec3 back = turned_about_axes({0, 0, 1}, degrees);
  return {centre + distance * back, centre, Projection::orthographic, turned_about_axes({0, 1, 0}, degrees)};
}

Camera turned(const Camera& camera, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  const auto turn = [&](const glm::dvec3& v) { return glm::dvec3(c * v.x - s * v.y, s * v.x + c * v.y, v.z); };
  return {camera.centre + turn(camera.eye - camera.centre), camera.centre, camera.projection, turn(camera.up)};
}

Basis basis(const Camera& camera) {
  const glm::dvec3 view = camera.centre - camera.eye;
  const double distance = glm::length(view);
  if (!finite(camera.eye) || !finite(camera.centre) || !(distance > 0.0) || !std::isfinite(distance)) {
    throw InputError("the camera's eye and centre must be different points at a finite distance");
  }
  const glm::dvec3 forward = glm::normalize(view);
  // A view straight up or down determines no horizontal direction; +y is up in this case, as in OpenSCAD.
  const glm::dvec3 across = glm::cross(forward, camera.up);
  const bool is_along = !(glm::length(across) > 1e-12);
  const glm::dvec3 right = glm::normalize(is_along ? glm::cross(forward, glm::dvec3(0, 1, 0)) : across);
  return {right, glm::cross(right, forward), forward};
}

double half_height_per_distance() { return std::tan(half_field_of_view); }

double half_height(const Camera& camera) {
  return half_height_per_distance() * glm::length(camera.centre - camera.eye);
}

double pixel_size(const Camera& camera, std::uint32_t height, double distance) {
  const double half =
      camera.projection == Projection::perspective ? half_height_per_distance() * distance : half_height(camera);
  return 2.0 * half / height;
}

Camera view_all(const Camera& camera, const facet::Box& box, std::uint32_t width, std::uint32_t height) {
  if (box.empty()) return camera;
  // A picture that is higher than wide has a horizontal field of view narrower than the vertical one.
  const double narrower = std::min(1.0, static_cast<double>(width) / height);
  const double half_angle = std::atan(half_height_per_distance() * narrower);
  const double radius = box.diagonal() / 2.0;
  const double distance = radius > 0.0 ? radius / std::sin(half_angle) : 1.0;
  const glm::dvec3 back = -basis(camera).forward;
  return {box.centre() + back * distance, box.centre(), camera.projection, camera.up};
}

Camera default_camera(const facet::Box& box, std::uint32_t width, std::uint32_t height) {
  // Rotated by 55 degrees about x and 25 degrees about z.
  constexpr double tilt = 55.0 * std::numbers::pi / 180.0;
  constexpr double turn = 25.0 * std::numbers::pi / 180.0;
  const glm::dvec3 back(std::sin(tilt) * std::sin(turn), -std::sin(tilt) * std::cos(turn), std::cos(tilt));
  const glm::dvec3 centre(0);
  return view_all({centre + 140.0 * back, centre}, box, width, height);
}

}  // namespace csgsim::view
