#include "hw/bit_serial_memory/kind.h"

namespace csgsim::bit_serial_memory {

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const auto controller = [&](const char* activity) {
    return machines::clocks_of(timing.account, "controller", activity);
  };
  return {{"rank of chips", controller("issuing")},
          {"clearing of the rows", controller("clearing")},
          {"reads of all enable bits", controller("answering")},
          {"refresh", controller("refreshing")},
          {"jumps of the host", controller("jumping")},
          {"link from the host", machines::clocks_of(timing.account, "host link", "sending")},
          {"scan-out", timing.account.count("scan_out_clocks")}};
}

}  // namespace csgsim::bit_serial_memory
