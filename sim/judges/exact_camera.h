// Cameras and pixel centres in exact numbers.
// Used by the sights of the judges.
#pragma once

#include <cstdint>
#include <limits>

#include "host/view/camera.h"
#include "hw/isa/depth_scale.h"
#include "hw/isa/program.h"
#include "sim/judges/dyadic.h"

namespace csgsim::judges {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A pixel centre as integers: twice its distance from the middle of the picture, to the right and down, in pixels.
struct Place {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

/// The centre of the pixel in that column and row.
constexpr Place make_place(std::uint32_t column, std::uint32_t row, std::uint32_t width, std::uint32_t height) {
  return {2 * static_cast<std::int32_t>(column) - (static_cast<std::int32_t>(width) - 1),
          2 * static_cast<std::int32_t>(row) - (static_cast<std::int32_t>(height) - 1)};
}

/// The exact linear function l0 + lx x + ly y.
struct ExactLinear {
  Dyadic l0, lx, ly;

  [[nodiscard]] Dyadic at(Place place) const;
};

/// A camera in exact numbers. Its direction v = centre - eye, r = v x up and u = r x v are exact and not normalized, so
/// that perpendicular and parallel planes are recognized exactly. Only the two lengths pixel / |r| and pixel / |u| are
/// irrational; they are computed to 100 digits.
struct ExactCamera {
  ExactCamera(const view::Camera& camera, std::uint32_t width, std::uint32_t height, const isa::DepthScale& depth);

  bool is_perspective;
  std::uint32_t width;
  std::uint32_t height;
  Vector eye;          ///< model space
  Vector forward;      ///< v
  Vector right;        ///< r
  Vector up;           ///< u
  Dyadic right_step;   ///< half a pixel in units of r
  Dyadic up_step;      ///< half a pixel in units of u
  Dyadic axis_length;  ///< |v|
  Dyadic near;
};

}  // namespace csgsim::judges
