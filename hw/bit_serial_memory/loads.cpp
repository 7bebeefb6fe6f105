#include "hw/bit_serial_memory/kind.h"

namespace csgsim::bit_serial_memory {

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const auto controller = [&](const char* activity) {
    return machines::clocks_of(timing.account, "controller", activity);
  };
  return {{"rank of chips", "carries out row commands", controller("issuing")},
          {"clearing of the rows", "runs", controller("clearing")},
          {"reads of all enable bits", "are waited for", controller("answering")},
          {"refresh", "closes the banks", controller("refreshing")},
          {"jumps of the host", "are waited for", controller("jumping")},
          {"link from the host", "sends", machines::clocks_of(timing.account, "host link", "sending")},
          {"scan-out", "holds the banks", timing.account.count("scan_out_clocks")}};
}

}  // namespace csgsim::bit_serial_memory
