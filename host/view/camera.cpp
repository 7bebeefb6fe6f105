#include "host/view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "hw/base/error.h"

namespace csgsim::view {

namespace {

constexpr double half_field_of_view = 11.25 * std::numbers::pi / 180.0;

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

Basis basis(const Camera& camera) {
  const glm::dvec3 view = camera.centre - camera.eye;
  const double distance = glm::length(view);
  if (!finite(camera.eye) || !finite(camera.centre) || !(distance > 0.0) || !std::isfinite(distance)) {
    throw InputError("the camera's eye and centre have to be two different points a finite distance apart");
  }
  const glm::dvec3 forward = glm::normalize(view);
  // Straight up and down there is no horizontal direction to take from the view; OpenSCAD does not turn the picture
  // then.
  const glm::dvec3 across = glm::cross(forward, glm::dvec3(0, 0, 1));
  const glm::dvec3 right = glm::length(across) > 1e-12 ? glm::normalize(across) : glm::dvec3(1, 0, 0);
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
  // A picture higher than wide is narrower than its vertical field of view.
  const double narrower = std::min(1.0, static_cast<double>(width) / height);
  const double half_angle = std::atan(half_height_per_distance() * narrower);
  const double radius = glm::length(box.high - box.low) / 2.0;
  const double distance = radius > 0.0 ? radius / std::sin(half_angle) : 1.0;
  const glm::dvec3 back = -basis(camera).forward;
  return {box.centre() + back * distance, box.centre(), camera.projection};
}

Camera default_camera(const facet::Box& box, std::uint32_t width, std::uint32_t height) {
  // Turned by 55 degrees about x and 25 degrees about z.
  constexpr double tilt = 55.0 * std::numbers::pi / 180.0;
  constexpr double turn = 25.0 * std::numbers::pi / 180.0;
  const glm::dvec3 back(std::sin(tilt) * std::sin(turn), -std::sin(tilt) * std::cos(turn), std::cos(tilt));
  const glm::dvec3 centre(0);
  return view_all({centre + 140.0 * back, centre, Projection::orthographic}, box, width, height);
}

}  // namespace csgsim::view
