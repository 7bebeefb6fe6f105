#include "hw/multi_processor/account.h"
#include "hw/multi_processor/kind.h"

namespace csgsim::multi_processor {

namespace {

/// Load of the node that works most.
machines::Load busiest(const machines::Account& account) {
  machines::Load load{"nodes", 0};
  for (const machines::PartAccount& part : account.parts) {
    if (!part.part.starts_with("node ")) continue;
    std::uint64_t clocks = 0;
    for (const NodeActivity one : {NodeActivity::pruning, NodeActivity::sharing, NodeActivity::rendering})
      clocks += machines::clocks_of(account, part.part, name_of(one));
    if (clocks > load.clocks) load = {part.part, clocks};
  }
  return load;
}

}  // namespace

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const auto display = [&](DisplayActivity activity) {
    return machines::clocks_of(timing.account, "display processor", name_of(activity));
  };
  const auto bus = [&](BusActivity activity) {
    return machines::clocks_of(timing.account, "control bus", name_of(activity));
  };
  return {{"link from the host", display(DisplayActivity::receiving)},
          {"display processor", display(DisplayActivity::transforming) + display(DisplayActivity::dividing) +
                                    display(DisplayActivity::broadcasting)},
          {"control bus", bus(BusActivity::busy) + bus(BusActivity::granting)},
          busiest(timing.account)};
}

}  // namespace csgsim::multi_processor
