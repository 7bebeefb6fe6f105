#include <algorithm>

#include "hw/pixel_planes/kind.h"

namespace csgsim::pixel_planes {

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const auto controller = [&](const char* activity) {
    return machines::clocks_of(timing.account, "controller", activity);
  };
  // Clocks in which rows are latched after the picture was drawn; with two buffers the copying of the picture also
  // counts.
  const std::uint64_t latched = timing.interval_clocks - std::min(timing.clocks, timing.interval_clocks);
  return {{"array", controller("issuing") + controller("draining")},
          {"clearing of the array", controller("clearing")},
          {"global OR", controller("answering")},
          {"jumps of the host", controller("jumping")},
          {"link from the host", machines::clocks_of(timing.account, "host link", "sending")},
          {"scan-out", latched + controller("refreshing") + controller("holding") + controller("copying")}};
}

}  // namespace csgsim::pixel_planes
