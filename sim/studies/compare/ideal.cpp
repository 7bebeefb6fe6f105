#include "sim/studies/compare/ideal.h"

#include <utility>

namespace csgsim::studies {

std::vector<std::string> ideal_choices(const machines::Machine& machine) {
  std::vector<std::string> choices = machines::ideal_candidates(machine);
  if (choices.size() > 1) choices.emplace_back(every_figure);
  return choices;
}

machines::Machine with_ideal_parameters(machines::Machine machine, std::string_view choice) {
  if (choice.empty()) return machine;
  if (choice != every_figure) {
    machines::make_ideal(machine, choice);
    return machine;
  }
  for (const std::string& key : machines::ideal_candidates(machine)) machines::make_ideal(machine, key);
  return machine;
}

}  // namespace csgsim::studies
