#include "sim/studies/compare/ideal.h"

#include <utility>

namespace csgsim::studies {

std::vector<std::string> ideal_choices(const machines::Machine& machine) {
  std::vector<std::string> choices = machines::idealisable(machine);
  if (choices.size() > 1) choices.emplace_back(every_figure);
  return choices;
}

machines::Machine made_ideal(machines::Machine machine, std::string_view choice) {
  if (choice.empty()) return machine;
  if (choice != every_figure) {
    machines::idealise(machine, choice);
    return machine;
  }
  for (const std::string& key : machines::idealisable(machine)) machines::idealise(machine, key);
  return machine;
}

}  // namespace csgsim::studies
