#include "hw/machines/accounts.h"

#include <algorithm>
#include <stdexcept>

namespace csgsim::machines {

std::uint64_t Account::count(std::string_view name) const {
  const auto found = std::find_if(counts.begin(), counts.end(), [&](const Count& one) { return one.name == name; });
  if (found == counts.end()) throw std::out_of_range("an account has no " + std::string(name));
  return found->value;
}

}  // namespace csgsim::machines
