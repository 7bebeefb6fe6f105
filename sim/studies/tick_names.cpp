#include "sim/studies/tick_names.h"

#include <algorithm>

namespace csgsim::studies {

std::vector<std::string> tick_names(std::span<const std::string> machines) {
  std::vector<std::string> names;
  names.reserve(machines.size());
  for (const std::string& machine : machines) {
    std::size_t known = 0;
    for (const std::string& other : machines) {
      if (machine.starts_with(other + "+")) known = std::max(known, other.size());
    }
    names.push_back(machine.substr(known));
  }
  return names;
}

}  // namespace csgsim::studies
