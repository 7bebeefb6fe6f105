#include "sim/waves/view.h"

#include <algorithm>
#include <cmath>

namespace csgsim::waves {

std::uint64_t clock_period_ps(const machines::Machine& machine) {
  return static_cast<std::uint64_t>(std::llround(1.0 / static_cast<double>(machine.clock_hz) * 1e12));
}

std::vector<const wave::Tap*> ordered_taps(const Recording& recording) {
  std::vector<const wave::Tap*> taps;
  for (const wave::Tap& tap : recording.taps) taps.push_back(&tap);
  std::stable_partition(taps.begin(), taps.end(), [](const wave::Tap* tap) { return tap->name.starts_with("pixel_"); });
  return taps;
}

std::string_view unit_name(const wave::Tap& tap) {
  const std::string_view name = tap.name;
  return name.substr(0, name.rfind('.'));
}

}  // namespace csgsim::waves
