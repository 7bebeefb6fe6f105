#include "host/solids/resize.h"

#include <glm/common.hpp>

namespace csgsim::solids {

glm::dvec3 resize_scale(const glm::dvec3& size, const glm::dvec3& to, const std::array<bool, 3>& automatic,
                        Resized what) {
  const glm::dvec3 new_size = what == Resized::one ? glm::max(to, glm::dvec3(0)) : to;
  glm::dvec3 scale(1);
  int largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (new_size[axis] == 0) continue;
    if (size[axis] == 0) return glm::dvec3(1);
    scale[axis] = new_size[axis] / size[axis];
    if (new_size[axis] > new_size[largest]) largest = axis;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (automatic[static_cast<std::size_t>(axis)] && new_size[axis] == 0) scale[axis] = scale[largest];
  }
  return scale;
}

}  // namespace csgsim::solids
