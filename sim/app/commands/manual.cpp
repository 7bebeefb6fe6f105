#include "host/effects/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hw/isa/manual.h"
#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "sim/app/commands/commands.h"
#include "sim/shell/lists.h"
#include "sim/shell/machine_list.h"
#include "sim/shell/read_by.h"
#include "sim/shell/settings/sets.h"
#include "sim/shell/usage.h"

namespace csgsim::app {

namespace {

struct Options {
  std::string topic;
  std::string machines;
  std::vector<std::string> sets;
};

void print_figures(const machines::Machine& machine) {
  fmt::print("{}\n  {}\n\n", machine.name, machine.description);
  for (const machines::Figure& figure : machine.figures) {
    fmt::print("  {:<26}{:>12} {:<22}{:<10} {}\n", figure.key, figure.value, figure.unit, figure.provenance,
               figure.source);
  }
  const std::vector<std::string> ideal = machines::idealisations(machine);
  if (!ideal.empty()) fmt::print("\n  ideal, as no hardware is: {}\n", fmt::join(ideal, ", "));
}

/// What each machine is; of those that are named every figure, with where it comes from.
void print_machines(const Options& options) {
  refuse_scene_sets(options.sets);
  const bool are_listed = options.machines.empty() && options.sets.empty();
  const bool are_all = options.machines.empty() || options.machines == "all";
  for (const std::string& name : with_figures(parse_words(are_all ? all_machines() : options.machines), options.sets)) {
    const machines::Machine machine = kinds::load(name);
    if (are_listed) {
      fmt::print("{:<17}{}\n", machine.name, machine.description);
    } else {
      print_figures(machine);
    }
  }
  if (are_listed) fmt::print("\ncsgsim manual machines NAME prints every figure of one, with where it comes from.\n");
}

struct Topic {
  const char* name;
  const char* meaning;
  void (*print)(const Options& options);
};

constexpr std::array topics{
    Topic{"machines", "the machines; of one that is named every figure, with where it comes from", print_machines},
    Topic{"instructions", "the page of the broadcast instruction set, in Markdown",
          [](const Options& /*options*/) { fmt::print("{}", isa::instruction_set_page()); }},
    Topic{"scenes", "the page of scene files and their effects, in Markdown",
          [](const Options& /*options*/) { fmt::print("{}", effects::scene_page()); }},
};

void run(const Options& options) {
  const auto* const topic = std::ranges::find(topics, options.topic, &Topic::name);
  if (topic == topics.end()) {
    for (const Topic& one : topics) fmt::print("{:<14}{}\n", one.name, one.meaning);
    return;
  }
  const bool asks_of_machines = !options.machines.empty() || !options.sets.empty();
  if (asks_of_machines && topic->print != print_machines)
    throw UsageError("MACHINE", "csgsim manual " + options.topic + " is of no machine; leave it out");
  topic->print(options);
}

}  // namespace

void add_manual(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command = line.add("manual", "Tell of the machines, the instruction set, scene files",
                             "Example:\n  csgsim manual machines\n  csgsim manual machines pixel-planes-4 --set "
                             "alu.bits=4\n  csgsim manual instructions > docs/instruction-set.md\n"
                             "Without a topic it lists them.");
  std::vector<std::string> names;
  names.reserve(topics.size());
  for (const Topic& topic : topics) names.emplace_back(topic.name);
  command.option("TOPIC", options->topic, "What to tell of").one_of(names, "topic");
  command.option("MACHINE", options->machines, "Machines, by name or .toml file, with commas; all of csgsim's: all")
      .check(is_read_by([](const std::string& list) {
        if (list != "all") check_machines(list);
      }));
  add_figure_sets(command, options->sets, "the machine, or of those that have it");
  command.runs([options] { run(*options); });
}

}  // namespace csgsim::app
