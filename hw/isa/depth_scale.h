// Converts between depth integers and distances. Used by host/effects, host/emit, host/view, sim/judges, sim/observe,
// sim/python and sim/story.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace csgsim::isa {

/// Maps distances from the eye along the view axis (d, model units) to the integers z of an n-bit depth field.
/// Orthographic: z = 1 + (d - near) * (2^n - 4) / (far - near).
/// Perspective:  z = 1 + (1/near - 1/d) * (2^n - 4) / (1/near - 1/far).
/// 0 is the near cap; 2^n - 1 means "nothing".
struct DepthScale {
  bool perspective = false;
  double near = 0;  ///< model units
  double far = 1;   ///< model units

  bool operator==(const DepthScale&) const = default;
};

/// Depth steps between the near and the far plane in a depth field of `depth_bits` bits.
inline double depth_steps(unsigned depth_bits) { return std::ldexp(1.0, static_cast<int>(depth_bits)) - 4.0; }

/// Depth value of a distance from the eye, before rounding; see DepthScale.
inline double depth_of(const DepthScale& scale, unsigned depth_bits, double distance) {
  const double part = scale.perspective ? (1.0 / scale.near - 1.0 / distance) / (1.0 / scale.near - 1.0 / scale.far)
                                        : (distance - scale.near) / (scale.far - scale.near);
  return 1.0 + part * depth_steps(depth_bits);
}

/// The inverse of depth_of(): the distance from the eye along the view axis, in model units.
inline double distance_at(const DepthScale& scale, unsigned depth_bits, double depth) {
  const double part = (depth - 1.0) / depth_steps(depth_bits);
  if (!scale.perspective) return scale.near + part * (scale.far - scale.near);
  return 1.0 / (1.0 / scale.near - part * (1.0 / scale.near - 1.0 / scale.far));
}

/// distance_at() for a depth value in memory; infinite for "nothing" (all ones).
inline double distance_of(const DepthScale& scale, unsigned depth_bits, std::uint32_t depth) {
  if (depth == (1ULL << depth_bits) - 1) return std::numeric_limits<double>::infinity();
  return distance_at(scale, depth_bits, depth);
}

}  // namespace csgsim::isa
