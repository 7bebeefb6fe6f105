#include "host/effects/flat_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace csgsim::effects {

glm::dvec3 shade(const FlatShading& shading, const glm::dvec3& colour, const glm::dvec3& normal) {
  const double cosine = std::max(0.0, glm::dot(glm::normalize(shading.to_light), normal));
  return colour * (shading.ambient + shading.diffuse * cosine);
}

}  // namespace csgsim::effects
