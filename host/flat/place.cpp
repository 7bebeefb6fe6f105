#include "host/flat/place.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "hw/base/error.h"

namespace csgsim::flat {

namespace {

/// Width and height of the bounding box of an area that is not empty.
glm::dvec2 extent(const Area& area) {
  glm::dvec2 low(std::numeric_limits<double>::infinity());
  glm::dvec2 high = -low;
  for (const Outline& outline : area.outlines) {
    for (const glm::dvec2& corner : outline) {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  }
  return high - low;
}

}  // namespace

Area transformed(const Area& area, const glm::dmat4& matrix) {
  const glm::dvec2 x(matrix[0]);
  const glm::dvec2 y(matrix[1]);
  const glm::dvec2 origin(matrix[3]);
  const double determinant = x.x * y.y - x.y * y.x;
  if (determinant == 0) return {};
  Area result = area;
  for (Outline& outline : result.outlines) {
    for (glm::dvec2& corner : outline) {
      corner = x * corner.x + y * corner.y + origin;
      if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) {
        throw InputError(
            "a transformation gives a 2-D shape coordinates that are not finite; use smaller factors and offsets");
      }
    }
    if (determinant < 0) std::ranges::reverse(outline);
  }
  return result;
}

Area resized(const Area& area, const glm::dvec2& size, const glm::bvec2& automatic) {
  if (area.empty()) return {};
  const glm::dvec2 now = extent(area);
  const int larger = size.y != 0 && size.y > size.x ? 1 : 0;
  const double shared = size[larger] > 0 ? size[larger] / now[larger] : 1;
  glm::dmat4 scale(1);
  for (int axis = 0; axis < 2; ++axis) {
    scale[axis][axis] = size[axis] > 0 ? size[axis] / now[axis] : automatic[axis] ? shared : 1;
  }
  return transformed(area, scale);
}

}  // namespace csgsim::flat
