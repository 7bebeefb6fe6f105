#include "sim/observe/energy.h"

#include <algorithm>

namespace csgsim::observe {

std::optional<double> frame_joules(const machines::Account& account) {
  const auto found = std::ranges::find(account.counts, "frame_picojoules", &machines::Count::name);
  if (found == account.counts.end()) return std::nullopt;
  return static_cast<double>(found->value) * 1e-12;
}

}  // namespace csgsim::observe
