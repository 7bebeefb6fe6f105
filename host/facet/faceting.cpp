#include "host/facet/faceting.h"

#include <cmath>
#include <numbers>
#include <string>

#include "host/model/fragments.h"
#include "hw/base/error.h"

namespace csgsim::facet {

std::uint32_t fragments_within(double radius, double tolerance) {
  if (tolerance >= radius / 2.0) return 3;  // the sides of any triangle reach halfway to the centre
  // 1 - cos(a) = 2 sin^2(a / 2) is exact for small angles too.
  const double angle = 2.0 * std::asin(std::sqrt(tolerance / (2.0 * radius)));
  const double count = std::ceil(std::numbers::pi / angle * (1.0 - 1e-12));
  if (!(count <= model::max_fragments)) {
    throw InputError("a circle needs more than " + std::to_string(model::max_fragments) +
                     " fragments; raise the tolerance");
  }
  return static_cast<std::uint32_t>(count);
}

}  // namespace csgsim::facet
