#include "sim/study/inputs.h"

#include <algorithm>

#include "hw/machines/kind.h"
#include "sim/study/hash.h"

namespace csgsim::study {

std::string hash_of(const machines::Machine& machine) {
  std::vector<std::string> lines{std::string(machine.kind->name)};
  for (const machines::Figure& figure : machine.figures) lines.push_back(figure.key + "=" + figure.value);
  std::sort(lines.begin(), lines.end());
  Hash hash;
  for (const std::string& line : lines) hash.add(line + "\n");
  return hash.text();
}

std::vector<std::string> differences(const Inputs& before, const Inputs& now) {
  std::vector<std::string> names;
  if (before.model_hash != now.model_hash) names.emplace_back("the model");
  if (before.machine_hash != now.machine_hash) names.emplace_back("the machine");
  if (before.csgsim != now.csgsim) names.emplace_back("csgsim");
  return names;
}

}  // namespace csgsim::study
