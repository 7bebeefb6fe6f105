#include "hw/pixel_square/account.h"
#include "hw/pixel_square/kind.h"

namespace csgsim::pixel_square {

namespace {

/// Of the renderers the one that draws most.
machines::Load busiest(const machines::Account& account) {
  machines::Load load{"renderer", "draws", 0};
  for (const machines::PartAccount& part : account.parts) {
    if (!part.part.starts_with("renderer ")) continue;
    const std::uint64_t clocks = machines::clocks_of(account, part.part, name_of(SquareActivity::working));
    if (clocks > load.clocks) load = {part.part, load.does, clocks};
  }
  return load;
}

}  // namespace

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const auto working = [&](const char* part) {
    return machines::clocks_of(timing.account, part, name_of(SquareActivity::working));
  };
  return {{"link from the host", "sends", working("host")},
          {"divider", "tests and sends", working("divider")},
          busiest(timing.account),
          {"frame buffer", "takes colours", working("frame buffer")}};
}

}  // namespace csgsim::pixel_square
