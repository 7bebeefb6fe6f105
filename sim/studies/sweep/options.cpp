#include "sim/studies/sweep/options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "host/emit/curves.h"
#include "hw/kinds/load.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/prunings.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/dimensions.h"

namespace csgsim::studies {

namespace {

session::Check is_axis_list(const char* key) { return session::check_by_parsing(find_axis(key)->values); }

}  // namespace

std::string default_strategies() { return fmt::format("{}", fmt::join(names_of(emit::default_strategies()), ",")); }

std::vector<session::ModelRequest> SweepOptions::designs() const {
  const auto values = [](const char* key, const std::string& list) { return find_axis(key)->values(list); };
  const std::vector<Dimension> dimensions{
      {"z-bits", values("z-bits", z_bits)},           {"pruning", session::parse_words(prunings)},
      {"curves", session::parse_words(curves)},       {"colouring", session::parse_words(colourings)},
      {"strategy", session::parse_words(strategies)}, {"stack-bits", values("stack-bits", stack_bits)}};
  session::ModelRequest base = view;
  base.sets = session::divide_settings(view.sets).scene;
  const std::vector<std::string> with_sets = session::with_parameters(session::parse_words(machines), view.sets);
  std::vector<session::ModelRequest> all;
  for (const std::string& model : without_duplicates(models)) {
    base.model = model;
    for (const std::string& machine : with_sets) {
      base.machine = machine;  // includes its parameters as set
      const std::string own = std::to_string(kinds::load(machine).array.memory_bits);
      for (const std::string& bits : memory_bits.empty() ? std::vector{own} : values("memory-bits", memory_bits)) {
        put(base, "memory-bits", bits);
        std::ranges::copy(DesignGrid(base, dimensions).designs(), std::back_inserter(all));
      }
    }
  }
  return all;
}

void SweepOptions::add_to(session::OptionList& command) {
  command.option("MODEL", models, "Models: OpenSCAD .csg files, OpenSCAD sources (.scad), commands (.jan), or meshes")
      .required();
  command.option("--strategy", strategies, "Classification strategies, separated by commas")
      .list_of(names_of(emit::strategies), "strategy");
  command.option("--stack-bits", stack_bits, "Numbers of stack bits, for strategy bits")
      .check(is_axis_list("stack-bits"));
  command.option("--z-bits", z_bits, "List of depth bits").check(is_axis_list("z-bits"));
  command.option("--colouring", colourings, "Colouring methods, separated by commas")
      .list_of(names_of(emit::colourings), "colouring");
  command
      .option("--pruning", prunings,
              "Prunings to apply, separated by commas: auto, all, none, those named (space+hidden) or all but those "
              "(no-space+no-hidden)")
      .words(session::pruning_words(), session::check_by_parsing(session::parse_prunings));
  command.option("--machines", machines, "Machines, as names or .toml files separated by commas")
      .check(session::check_by_parsing(session::check_machines));
  command
      .option("--memory-bits", memory_bits, "List of memory bits per pixel; default: as in the machine's description")
      .check(is_axis_list("memory-bits"));
  view.add_view_to(command);
  command.remove("--curves");
  command.option("--curves", curves, "Ways to draw spheres, cylinders and cones, separated by commas")
      .list_of(names_of(emit::curve_choices), "way");
  command.flag("--no-draw", no_draw, "Count only; do not draw pictures to check that they are identical");
}

}  // namespace csgsim::studies
