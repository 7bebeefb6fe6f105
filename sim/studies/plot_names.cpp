#include "sim/studies/plot_names.h"

#include <algorithm>

#include "hw/base/hash.h"

namespace csgsim::studies {

std::string plot_stem(const std::filesystem::path& model) {
  constexpr std::size_t max_length = 100;
  std::string stem = model.stem().native();
  if (stem.size() <= max_length) return stem;
  Hash hash;
  hash.add(stem);
  return stem.substr(0, max_length) + "-" + hash.text();
}

std::vector<std::string> machine_tick_labels(std::span<const std::string> machines) {
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
