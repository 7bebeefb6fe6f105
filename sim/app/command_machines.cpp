#include <fmt/format.h>

#include <memory>

#include "hw/machines/machine.h"
#include "sim/app/commands.h"

namespace csgsim::app {

void add_machines(CLI::App& app) {
  const auto name = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("machines", "List the machines, each figure with where it comes from");
  command.footer("Example:\n  csgsim machines\n  csgsim machines pixel-planes-4");
  command.add_option("MACHINE", *name, "One machine only: its name or its .toml file");
  command.callback([name] {
    std::vector<std::string> wanted;
    if (name->empty()) {
      for (const std::string_view known : machines::built_in_names()) wanted.emplace_back(known);
    } else {
      wanted.push_back(*name);
    }
    for (const std::string& one : wanted) {
      const machines::Machine machine = machines::load(one);
      fmt::print("{}\n  {}\n\n", machine.name, machine.description);
      for (const machines::Figure& figure : machine.figures) {
        fmt::print("  {:<26}{:>12} {:<22}{:<10} {}\n", figure.key, figure.value, figure.unit, figure.provenance,
                   figure.source);
      }
    }
  });
}

}  // namespace csgsim::app
