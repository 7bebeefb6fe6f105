#include "host/effects/flat_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace csgsim::effects {

std::uint32_t pack(const glm::dvec3& colour) {
  std::uint32_t packed = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const double value = std::clamp(colour[channel], 0.0, 1.0);
    packed = packed << 8U | static_cast<std::uint32_t>(std::lround(value * 255.0));
  }
  return packed;
}

std::uint32_t shade(const FlatShading& shading, const glm::dvec3& colour, const glm::dvec3& normal) {
  const double cosine = std::max(0.0, glm::dot(glm::normalize(shading.to_light), normal));
  return pack(colour * (shading.ambient + shading.diffuse * cosine));
}

}  // namespace csgsim::effects
