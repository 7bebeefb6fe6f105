#include "host/effects/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/base/text.h"
#include "hw/isa/manual.h"
#include "hw/kinds/load.h"
#include "hw/machines/machine.h"
#include "hw/process/process.h"
#include "hw/process/published.h"
#include "hw/processors/processor.h"
#include "sim/app/commands/commands.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/machine_list.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/software/display/rows.h"
#include "sim/software/methods/rows.h"
#include "sim/software/space/directory.h"

namespace csgsim::app {

namespace {

struct Options {
  std::string topic;
  std::string machines;
  std::vector<std::string> sets;
};

/// Prints the parameters of a machine, a processor or a process.
template <class Described>
void print_parameters_of(const Described& described) {
  fmt::print("{}\n  {}\n\n", described.name, described.description);
  for (const machines::Figure& figure : described.figures) {
    fmt::print("  {:<26}{:>12} {:<22}{:<10} {}\n", figure.key, figure.value, figure.unit, figure.provenance,
               figure.source);
    if (figure.range)
      fmt::print("  {:<26}{:>12} {:<22}{:<10} {}\n", "", fmt::format("{} to {}", figure.range->low, figure.range->high),
                 figure.unit, "range", figure.range->reason);
  }
}

void print_parameters(machines::Machine machine) {
  for (machines::Figure& figure : machine.figures) figure.value = machines::used_value(figure, machine);
  print_parameters_of(machine);
  const std::vector<std::string> ideal = machines::ideal_parameters(machine);
  if (!ideal.empty()) fmt::print("\n  idealized, unlike any hardware: {}\n", fmt::join(ideal, ", "));
}

/// Lists the machines, or prints every parameter of the named ones with its source.
void print_machines(const Options& options) {
  refuse_scene_sets(options.sets);
  const bool are_listed = options.machines.empty() && options.sets.empty();
  const bool are_all = options.machines.empty() || options.machines == "all";
  for (const std::string& name :
       with_parameters(parse_words(are_all ? built_in_machines_text() : options.machines), options.sets)) {
    const machines::Machine machine = kinds::load(name);
    if (are_listed) {
      fmt::print("{:<16} {}\n", machine.name, machine.description);
    } else {
      print_parameters(machine);
    }
  }
  if (are_listed) fmt::print("\ncsgsim manual machines NAME prints every parameter of one, with its source.\n");
}

/// The names of a list, or all of them.
std::vector<std::string> named(const std::string& list, const std::vector<std::string_view>& all) {
  return list == "all" ? std::vector<std::string>(all.begin(), all.end()) : parse_words(list);
}

/// Lists processors or processes, or prints every parameter of the named ones.
template <class Load>
void print_described(const Options& options, const std::vector<std::string_view>& all, Load load) {
  if (options.machines.empty()) {
    for (const std::string_view name : all) fmt::print("{:<17}{}\n", name, load(std::string(name)).description);
    fmt::print("\ncsgsim manual {} NAME prints every parameter of one, with its source.\n", options.topic);
    return;
  }
  for (const std::string& name : named(options.machines, all))
    print_parameters_of(for_option("NAME", [&] { return load(name); }));
}

void print_processors(const Options& options) {
  print_described(options, processors::processor_names(), processors::load_processor);
}

void print_processes(const Options& options) {
  print_described(options, process::process_names(), process::load_process);
}

/// What became of a published quantity, with the deviation that a prediction may have.
std::string use_of(const process::Quantity& quantity) {
  switch (quantity.use) {
    case process::Use::fitted: return fmt::format("fitted by `{}`", quantity.parameter);
    case process::Use::predicted: return fmt::format("predicted; {:.0f} % accepted", 100 * quantity.tolerance);
    case process::Use::not_found: return "predicted; not found";
  }
  throw std::logic_error("unknown use of a published quantity");
}

/// Prints what is published about chips beside the model, as a table in Markdown.
void print_chips(const Options& options) {
  fmt::print("| process | quantity | published | model | deviation | use | source |\n|---|---|--:|--:|--:|---|---|\n");
  const std::string list = options.machines.empty() ? "all" : options.machines;
  for (const std::string& name : named(list, process::process_names())) {
    const process::Process process = for_option("NAME", [&] { return process::load_process(name); });
    for (const process::Comparison& one : process::compare_published(
             process, [](std::string_view machine) { return kinds::load(std::string(machine)); })) {
      const process::Quantity& quantity = one.quantity;
      const bool is_found = quantity.published > 0;
      const std::string reason = quantity.reason.empty() ? "" : fmt::format("; {}", quantity.reason);
      fmt::print("| `{}` | {} | {} | {} | {} | {} | {}{} |\n", process.name, quantity.what,
                 is_found ? rounded(quantity.published) : "", rounded(one.model),
                 quantity.use == process::Use::predicted ? fmt::format("{:+.0f} %", 100 * one.deviation()) : "",
                 use_of(quantity), quantity.source, reason);
    }
  }
}

template <class Rows>
void print_rows(const char* what, const Rows& rows) {
  fmt::print("{}\n", what);
  for (const auto& row : rows) fmt::print("  {:<21}{}\n", row.name, row.help);
}

/// Prints the software methods of csgsim classify, and the values of the options with which they can be combined.
void print_methods(const Options& /*options*/) {
  fmt::print("Methods (--methods)\n");
  for (const software::MethodRow* const row : software::methods())
    fmt::print("  {:<21}{} ({})\n", row->name, row->help, row->source);
  fmt::print("\nState kept between points (--coherences)\n");
  for (const software::CoherenceRow& row : software::coherences())
    fmt::print("  {:<21}{} ({})\n", row.name, row.help, row.source);
  fmt::print("\n");
  print_rows("Shapes of the tree (--shapes)", software::shapes());
  fmt::print("\n");
  print_rows("Pruning of trees in advance (--reduced)", software::prunings());
  fmt::print("\nFacet directories of csgsim trace (--directories)\n");
  for (const software::DirectoryRow* const row : software::directories())
    fmt::print("  {:<21}{} ({})\n", row->name, row->help, row->source);
  fmt::print("\nMethods that draw facet by facet (display --methods)\n");
  for (const software::DisplayRow* const row : software::display_methods())
    fmt::print("  {:<27}{} ({})\n", row->name, row->help, row->source);
  fmt::print(
      "\ncompare --with accepts PROCESSOR:METHOD or PROCESSOR:METHOD/COHERENCE; csgsim manual processors lists "
      "processors.\n");
}

struct Topic {
  const char* name;
  const char* meaning;
  void (*print)(const Options& options);
};

constexpr std::array topics{
    Topic{"machines", "the machines, or every parameter of the named ones with its source", print_machines},
    Topic{"methods", "the software methods of csgsim classify, display and trace, with sources", print_methods},
    Topic{"processors", "the processors for which software is timed, or every parameter of the named ones",
          print_processors},
    Topic{"processes",
          "the processes for which csgsim explore computes area and energy, or every parameter of the named ones",
          print_processes},
    Topic{"chips", "what is published about chips beside the model of each process, or of the named ones", print_chips},
    Topic{"instructions", "the broadcast instruction set, as a Markdown page",
          [](const Options& /*options*/) { fmt::print("{}", isa::instruction_set_page()); }},
    Topic{"scenes", "scene files and their effects, as a Markdown page",
          [](const Options& /*options*/) { fmt::print("{}", effects::scene_page()); }},
};

void run(const Options& options) {
  const auto* const topic = std::ranges::find(topics, options.topic, &Topic::name);
  if (topic == topics.end()) {
    for (const Topic& one : topics) fmt::print("{:<14}{}\n", one.name, one.meaning);
    return;
  }
  const bool is_of_machines = topic->print == print_machines;
  const bool names_some = is_of_machines || topic->print == print_processors || topic->print == print_processes ||
                          topic->print == print_chips;
  if (!options.machines.empty() && !names_some)
    throw UsageError("NAME", "csgsim manual " + options.topic + " accepts no name; leave it out");
  if (!options.sets.empty() && !is_of_machines)
    throw UsageError("--set", "csgsim manual " + options.topic + " has no parameters to change; leave it out");
  if (is_of_machines && !options.machines.empty() && options.machines != "all")
    for_option("NAME", [&] { check_machines(options.machines); });
  topic->print(options);
}

void add_manual(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("manual", hardware_group,
               "Print the machines and their parameters, the instruction set, software methods, scene files",
               "Example:\n  csgsim manual machines\n  csgsim manual machines pixel-planes-4 --set "
               "alu.bits=4\n  csgsim manual instructions > docs/instruction-set.md\n"
               "Without a topic it lists the topics.");
  std::vector<std::string> names;
  names.reserve(topics.size());
  for (const Topic& topic : topics) names.emplace_back(topic.name);
  command.option("TOPIC", options->topic, "What to print").one_of(names, "topic");
  command.option("NAME", options->machines,
                 "Comma-separated machines, processors or processes, by name or .toml file; all: every built-in one");
  add_parameter_sets(command, options->sets, "the machine, or of those that have it");
  command.set_action([options] { run(*options); });
}

}  // namespace

extern const CommandRow manual_row{.name = "manual", .add = add_manual, .needs_all_commands = true};

}  // namespace csgsim::app
