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
machines::Load busiest(const machines::Account& account, std::string_view name, std::string_view does) {
  machines::Load load{std::string(name), does, 0};
  for (const machines::PartAccount& part : account.parts) {
    if (part.part != name && !part.part.starts_with(std::string(name) + " ")) continue;
    const std::uint64_t clocks = working(account, part.part);
    if (clocks > load.clocks) load = {part.part, load.does, clocks};
  }
  return load;
}

/// Loads of the units that distribute the squares, and of the ring.
std::vector<machines::Load> front_loads(const machines::Account& account) {
  const bool has_ring = std::ranges::any_of(account.parts, [](const auto& part) { return part.part == "ring"; });
  if (has_ring) {
    return {busiest(account, "processor", "sends"),
            {"ring", "carries as much as it can", account.count("ring_full_clocks")}};
  }
  return {{"link from the host", "sends", working(account, "host")},
          busiest(account, "divider", "tests and writes"),
          busiest(account, "sender", "sends")};
}

}  // namespace

std::vector<machines::Load> Kind::loads(const machines::FrameTiming& timing) const {
  const machines::Account& account = timing.account;
  const std::uint64_t refreshing = machines::clocks_of(account, "frame buffer", name_of(SquareActivity::refreshing));
  std::vector<machines::Load> loads = front_loads(account);
  loads.push_back(busiest(account, "renderer", "draws"));
  loads.push_back({"frame buffer", "takes colours or shows them", working(account, "frame buffer") + refreshing});
  return loads;
}

}  // namespace csgsim::pixel_square
