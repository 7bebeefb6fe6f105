#include "hw/machines/load.h"

#include <algorithm>

namespace csgsim::machines {

std::uint64_t clocks_of(const Account& account, std::string_view part, std::string_view activity) {
  const auto told = std::ranges::find(account.parts, part, &PartAccount::part);
  if (told == account.parts.end()) return 0;
  const auto found = std::ranges::find(told->clocks, activity, &ActivityClocks::activity);
  return found == told->clocks.end() ? 0 : found->clocks;
}

}  // namespace csgsim::machines
