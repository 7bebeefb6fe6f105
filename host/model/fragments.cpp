#include "host/model/fragments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "hw/base/error.h"

namespace csgsim::model {

std::uint32_t fragments(double radius, const FacetControl& control) {
  if (radius < grid_fine || !std::isfinite(control.fn)) return 3;
  const double count =
      control.fn > 0.0
          ? std::max(std::floor(control.fn), 3.0)
          : std::ceil(std::max(std::min(360.0 / control.fa, radius * 2.0 * std::numbers::pi / control.fs), 5.0));
  if (!(count <= max_fragments)) {
    throw InputError("a circle has more than " + std::to_string(max_fragments) +
                     " fragments; use a smaller $fn, or a larger $fa or $fs");
  }
  return static_cast<std::uint32_t>(count);
}

}  // namespace csgsim::model
