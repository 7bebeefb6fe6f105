#include "sim/studies/sweep/options.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "host/emit/curves.h"
#include "hw/isa/instruction.h"
#include "hw/kinds/load.h"
#include "sim/session/options/prunings.h"
#include "sim/session/options/sets.h"
#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

std::vector<unsigned> memory_bits_of(const std::string& text) {
  return session::parse_numbers(text, 1, isa::max_memory_bits);
}
std::vector<std::string> strategies_of(const std::string& text) {
  return session::parse_names(text, "strategy", names_of(emit::strategies));
}
std::vector<std::string> colourings_of(const std::string& text) {
  return session::parse_names(text, "colouring", names_of(emit::colourings));
}
std::vector<std::string> curves_of(const std::string& text) {
  return session::parse_names(text, "way", names_of(emit::curve_choices));
}

SweepRanges ranges_of(const SweepOptions& options) {
  SweepRanges ranges;
  for (const std::string& model : options.models) {
    if (std::find(ranges.models.begin(), ranges.models.end(), model) == ranges.models.end())
      ranges.models.push_back(model);
  }
  ranges.machines = session::with_figures(session::parse_words(options.machines), options.view.sets);
  for (const std::string& machine : ranges.machines) {
    ranges.memory_bits[machine] = options.memory_bits.empty() ? std::vector{kinds::load(machine).array.memory_bits}
                                                              : memory_bits_of(options.memory_bits);
  }
  ranges.z_bits = z_bits_of(options.z_bits);
  ranges.prunings = session::prunings_of(options.prunings);
  ranges.colourings = colourings_of(options.colourings);
  ranges.curves = curves_of(options.curves);
  ranges.strategies = strategies_of(options.strategies);
  ranges.stack_bits = stack_bits_of(options.stack_bits);
  return ranges;
}

}  // namespace

std::string usual_strategies() { return fmt::format("{}", fmt::join(names_of(emit::usual_strategies()), ",")); }

std::vector<SweepPoint> SweepOptions::points() const { return points_of(ranges_of(*this)); }

session::ModelRequest SweepOptions::at(const SweepPoint& point) const {
  session::ModelRequest one = view;
  one.model = point.model;
  one.machine = point.machine;  // with its figures as set
  one.sets = session::sorted(view.sets).scene;
  one.memory_bits = point.memory_bits;
  one.z_bits = point.z_bits;
  one.pruning = point.pruning;
  one.colouring = point.colouring;
  one.curves = point.curves;
  one.strategy = point.strategy;
  if (point.stack_bits > 0) one.stack_bits = point.stack_bits;
  return one;
}

void SweepOptions::add_to(session::OptionList& command) {
  command.option("MODEL", models, "The models, OpenSCAD .csg files, sources, .scad, or commands, .jan").required();
  command.option("--strategy", strategies, "List of the ways in which classifications are worked out")
      .list_of(names_of(emit::strategies), "strategy");
  add_list(command, "--stack-bits", stack_bits, stack_bits_of, "Numbers: bits that strategy bits is given");
  add_list(command, "--z-bits", z_bits, z_bits_of, "Numbers: bits of depth");
  command.option("--colouring", colourings, "List of the ways in which colours get to the pixels")
      .list_of(names_of(emit::colourings), "colouring");
  command
      .option("--pruning", prunings,
              "List of which prunings are done: all, none, those named (space+hidden) or all but those "
              "(no-space+no-hidden)")
      .words(session::pruning_words(), session::is_read_by(session::prunings_of));
  add_list(command, "--machines", machines, session::check_machines, "List of machines, by name or .toml file");
  add_list(command, "--memory-bits", memory_bits, memory_bits_of,
           "Numbers: memory bits a pixel; the machine's own if not given");
  view.add_view_to(command);
  command.remove("--curves");
  command
      .option("--curves", curves,
              "List of the ways in which spheres, cylinders and cones are drawn: facets, exact, auto")
      .list_of(names_of(emit::curve_choices), "way");
  command.flag("--no-draw", no_draw, "Count only; do not draw to see that all pictures are the same");
}

}  // namespace csgsim::studies
