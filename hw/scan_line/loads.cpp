#include "hw/scan_line/kind.h"

namespace csgsim::scan_line {

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const auto of = [&](const char* part, const char* activity) {
    return machines::clocks_of(timing.account, part, activity);
  };
  return {{"host", of("host", "sorting") + of("host", "updating") + of("host", "preparing") + of("host", "starting")},
          {"link from the host", of("link", "sending")},
          {"chain of cells", of("entry", "entering")},
          {"refresh path", of("refresh", "showing")}};
}

}  // namespace csgsim::scan_line
