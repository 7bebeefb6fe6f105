#include <fmt/format.h>

#include <memory>

#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "sim/app/commands/commands.h"
#include "sim/shell/settings/sets.h"

namespace csgsim::app {

void add_machines(CommandLine& line) {
  const auto name = std::make_shared<std::string>();
  const auto sets = std::make_shared<std::vector<std::string>>();
  Command command =
      line.add("machines", "List the machines, each figure with where it comes from",
               "Example:\n  csgsim machines\n  csgsim machines pixel-planes-4\n  csgsim machines pixel-planes-4 --set "
               "alu.bits=4");
  command.option("MACHINE", *name, "One machine only: its name or its .toml file");
  add_figure_sets(command, *sets, "the machine, or of those that have it");
  command.runs([name, sets] {
    refuse_scene_sets(*sets);
    std::vector<std::string> wanted;
    if (name->empty()) {
      for (const std::string_view known : kinds::built_in_names()) wanted.emplace_back(known);
    } else {
      wanted.push_back(*name);
    }
    for (const std::string& one : with_figures(wanted, *sets)) {
      const machines::Machine machine = kinds::load(one);
      fmt::print("{}\n  {}\n\n", machine.name, machine.description);
      for (const machines::Figure& figure : machine.figures) {
        fmt::print("  {:<26}{:>12} {:<22}{:<10} {}\n", figure.key, figure.value, figure.unit, figure.provenance,
                   figure.source);
      }
      const std::vector<std::string> ideal = machines::idealisations(machine);
      if (!ideal.empty()) fmt::print("\n  ideal, as no hardware is: {}\n", fmt::join(ideal, ", "));
    }
  });
}

}  // namespace csgsim::app
