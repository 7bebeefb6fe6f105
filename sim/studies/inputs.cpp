#include "sim/studies/inputs.h"

namespace csgsim::studies {

std::vector<std::string> changed_inputs(const Inputs& before, const Inputs& now) {
  std::vector<std::string> names;
  if (before.model_hash != now.model_hash) names.emplace_back("the model");
  if (before.machine_hash != now.machine_hash) names.emplace_back("the machine");
  if (before.csgsim != now.csgsim) names.emplace_back("csgsim");
  return names;
}

}  // namespace csgsim::studies
