#include "sim/studies/explore/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "hw/machines/names.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/progress.h"
#include "sim/session/options/read_by.h"
#include "sim/session/options/sets.h"
#include "sim/session/options/usage.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/front.h"
#include "sim/studies/dimensions.h"
#include "sim/studies/sensitivity/figures.h"

namespace csgsim::studies {

namespace {

constexpr std::string_view clock_figure = "clock.frequency";

/// The name as typed, given its escaped form in a row.
std::string named(const std::vector<std::string>& names, const std::string& escaped_name) {
  const auto found = std::ranges::find(names, escaped_name, [](const std::string& name) { return escaped(name); });
  return found == names.end() ? escaped_name : *found;
}

std::string key_of(const std::string& set) { return set.substr(0, set.find('=')); }

std::vector<Dimension> dimensions_of(const ExploreOptions& options) {
  std::vector<Dimension> dimensions;
  for (const std::string& text : options.vary)
    dimensions.push_back(session::for_option("--vary", [&] { return parse_dimension(text); }));
  return dimensions;
}

/// The machine's name with the parameters that were set.
std::string machine_of(const ExploreOptions& options) {
  return session::with_parameters({options.model.machine}, options.model.sets).front();
}

/// The machine with the parameters that were set, which become part of its name.
session::ModelRequest base_name(const ExploreOptions& options, const std::vector<Dimension>& dimensions) {
  session::ModelRequest base = options.model;
  base.sets = session::divide_settings(options.model.sets).scene;
  base.machine = machine_of(options);
  for (const std::string& change : machines::changes_of(base.machine)) {
    if (std::ranges::find(dimensions, key_of(change), &Dimension::key) != dimensions.end())
      throw session::UsageError("--vary", "'" + key_of(change) + "' is both varied and fixed; remove one");
  }
  if (!options.process.empty() && std::ranges::find(dimensions, clock_figure, &Dimension::key) != dimensions.end())
    throw session::UsageError("--vary", "the process determines the clock; remove clock.frequency or --process");
  static_cast<void>(base.scene());  // read once for all designs
  return base;
}

/// Silicon and energy are known only in a process.
void refuse_unpriced_axes(const ExploreOptions& options) {
  if (options.axes.empty() || !options.process.empty()) return;
  for (const std::string& axis : session::parse_words(options.axes)) {
    if (axis == "silicon" || axis == "energy")
      throw session::UsageError("--axes", axis + " needs a process; add --process NAME, or leave it out");
  }
}

constexpr std::uint32_t default_samples = 64;

/// Throws UsageError for options that exclude each other.
void check_sensitivity(const ExploreOptions& options) {
  if (!options.sensitivity && options.samples)
    throw session::UsageError("--samples", "only --sensitivity takes samples; add it, or remove --samples");
  if (options.sensitivity && options.search > 0)
    throw session::UsageError("--sensitivity", "a search compares designs as stated; remove --search or --sensitivity");
}

std::vector<RangedFigure> figures_of(const ExploreOptions& options) {
  std::set<std::string> varied;
  for (const Dimension& dimension : dimensions_of(options)) varied.insert(dimension.key);
  std::vector<RangedFigure> figures;
  add_ranged_figures(kinds::load(machine_of(options)).figures, false, varied, figures);
  if (const std::optional<process::Process> process = options.loaded_process())
    add_ranged_figures(process->figures, true, varied, figures);
  if (figures.empty())
    throw session::UsageError(
        "--sensitivity", "no figure has a range: the files of the machine and the process state none, or all are set");
  return figures;
}

}  // namespace

std::vector<std::string> own_explore_options() {
  std::vector<std::string> names = axis_keys();
  for (const char* name : {"vary", "points", "seed", "search", "axes", "process", "sensitivity", "samples", "machine",
                           "set", "output", "threads", "shard", "no-plots", "progress", "report", "quiet"})
    names.emplace_back(name);
  return names;
}

void ExploreOptions::add_to(session::OptionList& command) {
  model.add_to(command);
  command.remove("MODEL");
  command.option("MODEL", models, "Models: OpenSCAD .csg files, OpenSCAD sources (.scad), commands (.jan), or meshes")
      .required();
  command.remove("--strategy");
  command
      .option("--strategy", model.strategy,
              "Classification strategy, unless it is varied; auto is excluded because it depends on memory, which is a "
              "result here")
      .one_of(fixed_names_of(emit::strategies));
  command.remove("--colouring");
  command.option("--colouring", model.colouring, "Colouring method, unless it is varied")
      .one_of(fixed_names_of(emit::colourings));
  command.remove("--memory-bits");
  command
      .option("--memory-bits", model.memory_bits,
              "Memory bits per pixel of every design; default: as many as its Program uses, not the machine's own")
      .between(1U, isa::max_memory_bits);
  command
      .option("--vary", vary,
              fmt::format("KEY=LIST: a parameter of the machine, as in alu.bits=1,2,4, or one of {}; once per key. "
                          "Every combination of values is a design",
                          fmt::join(axis_keys(), ", ")))
      .check(session::check_by_parsing(parse_dimension))
      .required();
  command
      .option("--points", points,
              "Sample N designs evenly from the grid; 0 = all combinations, "
              "at most 10,000")
      .between(0U, max_designs);
  command.option("--seed", seed, "Seed of the sample");
  command
      .option("--search", search,
              "Search for at most N further designs: neighbours of designs on the front, with the previous or next "
              "value of one key, repeated until all neighbours of the front have been tried")
      .between(0U, max_designs);
  command
      .option(
          "--axes", axes,
          "Quantities by which designs are compared, separated by commas: time (between frames), area (transistors), "
          "silicon (mm2, with a process), energy (per frame, with a process), memory (bits), wrong (pixels); "
          "default: time,area,memory,wrong, or with a process time,silicon,energy,memory,wrong")
      .list_of(explore_axis_names(), "axis");
  command.option(
      "--process", process,
      fmt::format("Semiconductor process that determines clock, silicon and energy: {}, or "
                  "a .toml file; to change parameters: NAME+KEY=VALUE. Without a process, a machine has the clock "
                  "of its description",
                  fmt::join(process::process_names(), ", ")));
  command.flag("--sensitivity", sensitivity,
               "Also measure each design with each assumed figure of the machine and the process at the low and at the "
               "high value of its range, and with samples of all of them; omits figures that are varied or set, and "
               "sizes of picture, array and memory");
  command
      .option("--samples", samples,
              fmt::format("Number of Latin-hypercube samples for --sensitivity, drawn with --seed: whole numbers, "
                          "uniform in the logarithm if the high value is more than 4 times the low one; default: {}",
                          default_samples))
      .between(0U, max_designs);
}

Variants ExploreOptions::variants() const {
  check_sensitivity(*this);
  if (!sensitivity) return {{}, {{}}};
  return make_variants(figures_of(*this), {samples.value_or(default_samples), seed});
}

std::string ExploreOptions::requested_axes() const {
  if (!axes.empty()) return axes;
  return process.empty() ? "time,area,memory,wrong" : "time,silicon,energy,memory,wrong";
}

std::optional<process::Process> ExploreOptions::loaded_process() const {
  if (process.empty()) return std::nullopt;
  if (!machines::file_of(process).empty()) return process::load_process(process);
  return session::for_option("--process", [&] { return process::load_process(process); });
}

DesignGrid ExploreOptions::designs() const {
  refuse_unpriced_axes(*this);
  const std::vector<Dimension> dimensions = dimensions_of(*this);
  return {base_name(*this, dimensions), dimensions, {points, seed}};
}

bool ExploreOptions::has_memory(const session::ModelRequest& design) const {
  if (design.memory_bits) return true;
  return std::ranges::any_of(machines::changes_of(design.machine),
                             [](const std::string& change) { return is_memory_figure(key_of(change)); });
}

std::string render_command(const ExploreOptions& options, const session::OptionList& command, const ExploreRow& row,
                           std::uint32_t memory_bits, const std::string& picture) {
  DesignPoint point = row.point;
  point.memory_bits = memory_bits;
  const std::string clock = row.clock_path.empty() ? "" : fmt::format("+{}={}", clock_figure, row.clock_hz);
  return "csgsim render " + shell_word(named(options.models, point.model)) +
         join_given_options(command, own_explore_options(), session::divide_settings(options.model.sets).scene) +
         shell_option("machine", point.machine + clock) + render_options(point) + shell_option("output", picture);
}

}  // namespace csgsim::studies
