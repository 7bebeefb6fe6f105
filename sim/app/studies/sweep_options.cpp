#include "sim/app/studies/sweep_options.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "host/emit/curves.h"
#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/isa/instruction.h"
#include "hw/kinds/load.h"
#include "sim/app/options.h"
#include "sim/app/prunings.h"
#include "sim/app/read_by.h"
#include "sim/app/run_options.h"
#include "sim/app/settings/sets.h"
#include "sim/app/studies/shard_run.h"
#include "sim/app/studies/subjects.h"
#include "sim/app/version.h"
#include "sim/study/ranges.h"

namespace csgsim::app {

namespace {

template <class Choices>
std::vector<std::string> names_of(const Choices& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto choice : choices) names.emplace_back(emit::name_of(choice));
  return names;
}

std::vector<unsigned> memory_bits_of(const std::string& text) {
  return study::parse_numbers(text, 1, isa::max_memory_bits);
}
std::vector<unsigned> z_bits_of(const std::string& text) {
  return study::parse_numbers(text, view::fewest_z_bits, view::most_z_bits);
}
std::vector<unsigned> stack_bits_of(const std::string& text) {
  return study::parse_numbers(text, emit::fewest_stack_bits, most_stack_bits);
}
std::vector<std::string> strategies_of(const std::string& text) {
  return study::parse_names(text, "strategy", names_of(emit::strategies));
}
std::vector<std::string> colourings_of(const std::string& text) {
  return study::parse_names(text, "colouring", names_of(emit::colourings));
}
std::vector<std::string> curves_of(const std::string& text) {
  return study::parse_names(text, "way to draw curves", names_of(emit::curve_choices));
}

study::SweepRanges ranges_of(const SweepOptions& options) {
  study::SweepRanges ranges;
  for (const std::string& model : options.models) {
    if (std::find(ranges.models.begin(), ranges.models.end(), model) == ranges.models.end())
      ranges.models.push_back(model);
  }
  ranges.machines = with_figures(study::parse_words(options.machines), options.view.sets);
  for (const std::string& machine : ranges.machines) {
    ranges.memory_bits[machine] = options.memory_bits.empty() ? std::vector{kinds::load(machine).array.memory_bits}
                                                              : memory_bits_of(options.memory_bits);
  }
  ranges.z_bits = z_bits_of(options.z_bits);
  ranges.prunings = prunings_of(options.prunings);
  ranges.colourings = colourings_of(options.colourings);
  ranges.curves = curves_of(options.curves);
  ranges.strategies = strategies_of(options.strategies);
  ranges.stack_bits = stack_bits_of(options.stack_bits);
  return ranges;
}

/// The options with which `csgsim render` would draw the point.
ModelOptions options_of(const SweepOptions& options, const study::SweepPoint& point) {
  ModelOptions one = options.view;
  one.model = point.model;
  one.machine = point.machine;  // with its figures as set
  one.sets = sorted(options.view.sets).scene;
  one.memory_bits = point.memory_bits;
  one.z_bits = point.z_bits;
  one.pruning = point.pruning;
  one.colouring = point.colouring;
  one.curves = point.curves;
  one.strategy = point.strategy;
  if (point.stack_bits > 0) one.stack_bits = point.stack_bits;
  return one;
}

}  // namespace

std::vector<study::SweepJob> jobs_of(const SweepOptions& options) {
  std::map<SubjectKey, ReadSubject> subjects;
  std::vector<study::SweepJob> jobs;
  for (study::SweepPoint& point : study::points_of(ranges_of(options))) {
    const ModelOptions one = options_of(options, point);
    const machines::Machine machine = machine_of(one);
    const auto [place, is_new] = subjects.try_emplace(subject_key(one, machine));
    ReadSubject& read = place->second;
    if (is_new) read = read_subject(one, machine);
    point.model = escaped(point.model);
    point.machine = escaped(point.machine);
    jobs.push_back({std::move(point),
                    read.subject,
                    read.subject ? camera_of(one, machine, read.subject->tree, read.subject->scene) : view::Camera{},
                    sampling_of(one, machine),
                    machine,
                    emit_options_of(one),
                    {read.hash, study::hash_of(machine), version_and_build()},
                    read.reason});
  }
  return jobs;
}

void SweepOptions::add_to(Command& command) {
  command.option("MODEL", models, "The models, OpenSCAD .csg files, or sources, .scad").required();
  command.option("-o,--output", folder, "Folder for sweep.csv, sweep.json and the plots").required().check(not_empty);
  const auto add_list = [&](const char* name, std::string& value, const auto& parse, const std::string& help) {
    command.option(name, value, help).check(is_read_by(parse));
  };
  command.option("--strategy", strategies, "List of the ways in which classifications are worked out")
      .list_of(names_of(emit::strategies), "strategy");
  add_list("--stack-bits", stack_bits, stack_bits_of, "Numbers: bits that strategy bits is given");
  add_list("--z-bits", z_bits, z_bits_of, "Numbers: bits of depth");
  command.option("--colouring", colourings, "List of the ways in which colours get to the pixels")
      .list_of(names_of(emit::colourings), "colouring");
  command
      .option("--pruning", prunings,
              "List of which prunings are done: all, none, those named (space+hidden) or all but those "
              "(no-space+no-hidden)")
      .words(pruning_words(), is_read_by(prunings_of));
  add_list("--machine", machines, study::parse_words, "List of machines, by name or .toml file");
  add_list("--memory-bits", memory_bits, memory_bits_of,
           "Numbers: memory bits a pixel; the machine's own if not given");
  view.add_view_to(command);
  command.remove("--curves");
  command
      .option("--curves", curves,
              "List of the ways in which spheres, cylinders and cones are drawn: facets, exact, auto")
      .list_of(names_of(emit::curve_choices), "way to draw curves");
  command.option("--threads", threads, "Points that are measured at the same time").between(1U, most_threads);
  command.flag("--no-draw", no_draw, "Count only; do not draw to see that all pictures are the same");
  command.flag("--no-plots", no_plots, "Do without plots (gnuplot)");
  add_shard(command, shard);
  report.add_to(command);
  add_progress(command, progress);
}

}  // namespace csgsim::app
