// The mapping between model space, eye space and picture.
// Used by the projection and sim/software.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/view/camera.h"
#include "hw/isa/depth_scale.h"

namespace csgsim::view {

/// Maps model space to eye space, and eye space to the picture.
struct EyeSpace {
  Basis axes;
  glm::dvec3 eye;
  bool perspective;
  double pixel;     ///< orthographic: model units per pixel; perspective: tangent per pixel
  double middle_x;  ///< column of the view axis, relative to the sample of the first pixel
  double middle_y;

  /// Coordinates along right, up and forward, relative to the eye, in model units.
  [[nodiscard]] glm::dvec3 to_eye(const glm::dvec3& point) const {
    const glm::dvec3 d = point - eye;
    return {glm::dot(d, axes.right), glm::dot(d, axes.up), glm::dot(d, axes.forward)};
  }
  [[nodiscard]] glm::dvec3 to_model(const glm::dvec3& in_eye) const {
    return eye + axes.right * in_eye.x + axes.up * in_eye.y + axes.forward * in_eye.z;
  }

  /// Column and row in pixels; pixels are sampled at integers. The third coordinate remains the distance.
  [[nodiscard]] glm::dvec3 to_picture(const glm::dvec3& in_eye) const {
    const double unit = unit_at(in_eye.z);
    return {middle_x + in_eye.x / unit, middle_y - in_eye.y / unit, in_eye.z};
  }
  [[nodiscard]] glm::dvec3 from_picture(const glm::dvec3& point) const {
    const double unit = unit_at(point.z);
    return {(point.x - middle_x) * unit, (middle_y - point.y) * unit, point.z};
  }

 private:
  [[nodiscard]] double unit_at(double distance) const { return perspective ? pixel * distance : pixel; }
};

}  // namespace csgsim::view
