#include <algorithm>
#include <string>
#include <string_view>

#include "hw/pixel_square/account.h"
#include "hw/pixel_square/kind.h"

namespace csgsim::pixel_square {

namespace {

std::uint64_t working(const machines::Account& account, std::string_view part) {
  return machines::clocks_of(account, part, name_of(SquareActivity::working));
}

/// Load of the busiest unit named `name`, or `name` followed by a number.
machines::Load busiest(const machines::Account& account, std::string_view name) {
  machines::Load load{std::string(name), 0};
  for (const machines::PartAccount& part : account.parts) {
    if (part.part != name && !part.part.starts_with(std::string(name) + " ")) continue;
    const std::uint64_t clocks = working(account, part.part);
    if (clocks > load.clocks) load = {part.part, clocks};
  }
  return load;
}

/// Loads of the units that distribute the squares, and of the ring.
std::vector<machines::Load> front_loads(const machines::Account& account) {
  const bool has_ring = std::ranges::any_of(account.parts, [](const auto& part) { return part.part == "ring"; });
  if (has_ring) {
    return {busiest(account, "processor"), {"ring", account.count("ring_full_clocks")}};
  }
  return {{"link from the host", working(account, "host")}, busiest(account, "divider"), busiest(account, "sender")};
}

}  // namespace

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const machines::Account& account = timing.account;
  const std::uint64_t refreshing = machines::clocks_of(account, "frame buffer", name_of(SquareActivity::refreshing));
  std::vector<machines::Load> loads = front_loads(account);
  loads.push_back(busiest(account, "renderer"));
  loads.push_back({"frame buffer", working(account, "frame buffer") + refreshing});
  return loads;
}

}  // namespace csgsim::pixel_square
