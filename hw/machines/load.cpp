#include "hw/machines/load.h"

#include <algorithm>

namespace csgsim::machines {

std::uint64_t clocks_of(const Account& account, std::string_view part, std::string_view activity) {
  const auto listed = std::ranges::find(account.parts, part, &PartAccount::part);
  if (listed == account.parts.end()) return 0;
  const auto found = std::ranges::find(listed->clocks, activity, &ActivityClocks::activity);
  return found == listed->clocks.end() ? 0 : found->clocks;
}

}  // namespace csgsim::machines
