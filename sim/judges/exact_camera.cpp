#include "sim/judges/exact_camera.h"

#include "hw/isa/depth_scale.h"

namespace csgsim::judges {

namespace {

/// tan(180/16 degrees).
Real tangent_of_half_field() {
  const Real root = sqrt(Real(2));
  return sqrt(4 + 2 * root) - root - 1;
}

/// Sine of the angle to the camera's upward direction below which a view has +y up.
constexpr double along_up = 1e-12;

}  // namespace

Dyadic ExactLinear::at(Place place) const {
  return l0 + Dyadic(static_cast<double>(place.x)) * lx + Dyadic(static_cast<double>(place.y)) * ly;
}

ExactCamera::ExactCamera(const view::Camera& camera, std::uint32_t picture_width, std::uint32_t picture_height,
                         const isa::DepthScale& depth)
    : is_perspective(camera.projection == view::Projection::perspective),
      width(picture_width),
      height(picture_height),
      eye(to_exact(camera.eye)),
      forward(to_exact(camera.centre) - to_exact(camera.eye)),
      near(is_perspective ? depth.near : 1.0) {
  const Real length = sqrt(dot(forward, forward).to_real());
  right = cross(forward, to_exact(camera.up));
  if (sqrt(dot(right, right).to_real()) <= along_up * length) right = cross(forward, to_exact({0, 1, 0}));
  up = cross(right, forward);
  const Real half_pixel = tangent_of_half_field() * length / height;
  right_step = Dyadic(Real(half_pixel / sqrt(dot(right, right).to_real())));
  up_step = Dyadic(Real(half_pixel / sqrt(dot(up, up).to_real())));
  axis_length = Dyadic(length);
}

}  // namespace csgsim::judges
