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
  return {{"array", "carries out instructions", controller("issuing") + controller("draining")},
          {"clearing of the array", "runs", controller("clearing")},
          {"global OR", "is waited for", controller("answering")},
          {"jumps of the host", "are waited for", controller("jumping")},
          {"link from the host", "sends", machines::clocks_of(timing.account, "host link", "sending")},
          {"scan-out", "holds the array",
           latched + controller("refreshing") + controller("holding") + controller("copying")}};
}

}  // namespace csgsim::pixel_planes
