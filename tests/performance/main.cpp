#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "hw/base/error.h"
#include "hw/base/messages.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/machine_list.h"
#include "sim/session/options/numbers.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/run_request.h"
#include "sim/shell/command_line.h"
#include "sim/studies/folder.h"
#include "tests/performance/bench.h"
#include "tests/performance/report.h"

namespace csgsim::bench {

using namespace session;
using namespace shell;

namespace {

constexpr unsigned most_rounds = 1000;

struct Options {
  std::vector<std::string> models;
  std::string machines = studied_machines_text();
  std::string levels = "functional,cycle";
  std::string parts = "speed,dense,rivals,growth,counts,schedule,works";
  std::string works = fmt::format("{}", fmt::join(work_names(), ","));
  std::string beside;
  std::string size = "512x512";
  std::uint32_t rounds = 5;
  double seconds = 3;
  std::string folder = "csgsim-bench";
  bool no_plots = false;
};

/// A part of the measurement, and the member for its results.
struct Part {
  std::string_view name;
  void (*measure)(const Settings& settings, Results& results);
};

constexpr std::array parts{
    Part{"speed", [](const auto& settings, auto& results) { results.speeds = measure_speeds(settings); }},
    Part{"dense", [](const auto& settings, auto& results) { results.dense = measure_dense(settings); }},
    Part{"rivals", [](const auto& settings, auto& results) { results.rivals = measure_rivals(settings); }},
    Part{"growth", [](const auto& settings, auto& results) { results.growths = measure_growths(settings); }},
    Part{"counts", [](const auto& settings, auto& results) { results.counts = measure_counts(settings); }},
    Part{"schedule", [](const auto& settings, auto& results) { results.schedules = measure_schedules(settings); }},
    Part{"works", [](const auto& settings, auto& results) { results.works = measure_commands(settings); }},
};

std::vector<std::string> levels_of(const std::string& text) { return parse_names(text, "level", level_names()); }

std::vector<std::string> part_names() {
  std::vector<std::string> known;
  known.reserve(parts.size());
  for (const Part& part : parts) known.emplace_back(part.name);
  return known;
}

std::vector<std::string> parts_of(const std::string& text) { return parse_names(text, "part", part_names()); }

void check_size(const std::string& text) { numbers<std::uint32_t>(text, 'x', 2, "--size", "WxH, as in 512x512"); }

Settings settings_of(const Options& options, const std::filesystem::path& folder) {
  return {.csgsim = std::filesystem::read_symlink("/proc/self/exe").replace_filename("csgsim"),
          .beside = options.beside.empty() ? std::filesystem::path() : std::filesystem::absolute(options.beside),
          .folder = folder,
          .models = {options.models.begin(), options.models.end()},
          .machines = parse_words(options.machines),
          .levels = levels_of(options.levels),
          .size = options.size,
          .rounds = {options.rounds, options.seconds},
          .works = parse_names(options.works, "work", work_names())};
}

Results measure(const Settings& settings, const std::string& asked) {
  Results results{.build = this_build(), .settings = settings};
  if (!settings.beside.empty()) results.other = name_of_build(settings.beside);
  for (const std::string& name : parts_of(asked))
    std::ranges::find(parts, name, &Part::name)->measure(settings, results);
  return results;
}

void run(const Options& options) {
  check_size(options.size);
  const std::vector<std::filesystem::path> inputs =
      input_files({options.models.begin(), options.models.end()}, parse_words(options.machines));
  const studies::StudyFolder folder(options.folder, "bench", inputs);
  const Results results = measure(settings_of(options, folder.path()), options.parts);
  const std::string tables = to_tables(results);
  write_file(folder.path() / "bench.json", to_json(results).dump(2) + "\n");
  write_file(folder.path() / "bench.md", tables);
  if (!options.no_plots) draw_growths(results);
  fmt::print("{}{}: bench.json, bench.md{}\n", tables, printable(folder.path().native()),
             options.no_plots || results.growths.empty() ? "" : ", and plots (.png, .svg) of the growth");
}

}  // namespace

void describe_measure(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("measure", "Measures", "Measure csgsim's own speed, in ratios: on this computer, of this build",
               "Example:\n  csgsim_bench measure carburettor.csg -o figures\n"
               "  csgsim_bench measure --machines pixel-planes-4 --parts speed,dense --rounds 9\n"
               "  xvfb-run -a csgsim_bench measure carburettor.csg --parts rivals\n"
               "Beside the models that are named it draws a grid of 64 cubes and a drilled sphere of 482 half-spaces.");
  command.option("MODEL", options->models, "Models, OpenSCAD .csg files (not sources); none: the generated ones only");
  command.option("--machines", options->machines, "List of machines, by name or .toml file");
  command.option("--levels", options->levels, "List of the levels that are measured").list_of(level_names(), "level");
  command
      .option(
          "--parts", options->parts,
          "List of what is measured: speed (simulated against wall time), dense (the clocked engine against a plain "
          "loop), rivals (OpenSCAD, POV-Ray, if installed), growth (against sizes and threads), counts (what does not "
          "depend on the computer), schedule (more threads than there are cores), works (whole commands, some minutes)")
      .list_of(part_names(), "part");
  command.option("--works", options->works, "List of the whole commands that part works measures")
      .list_of(work_names(), "work");
  command.option(
      "--beside", options->beside,
      "Another csgsim, as of an older commit, that speed, growth, counts and works measure in turn with this");
  command.option("--size", options->size, "Pixels of the pictures, WxH");
  command.option("--rounds", options->rounds, "Rounds of each comparison, of which the medians are taken")
      .between(1U, most_rounds);
  command.option("--seconds", options->seconds, "No further round of a comparison begins when it has taken so long");
  command
      .option("-o,--output", options->folder,
              "Folder for bench.json, bench.md (the tables), the plots, and what is drawn meanwhile")
      .check(not_empty);
  command.flag("--no-plots", options->no_plots, "Do without plots (gnuplot)");
  command.add_quiet_option();
  command.set_action([options] { run(*options); });
}

struct CountOptions {
  std::string program;
  std::string machine;
  bool json = false;
};

/// Uses the Program's own machine, unless another is named.
void count(const CountOptions& options) {
  const isa::Program program = isa::load_program(options.program);
  machines::Machine machine = options.machine.empty() ? kinds::load(program.machine) : kinds::load(options.machine);
  machines::adopt_shape(machine, program);
  const nlohmann::ordered_json counts = to_json(work_of(program, replay(program, machine)));
  if (options.json) {
    fmt::print("{}\n", counts.dump(2));
    return;
  }
  for (const auto& [name, value] : counts.items()) fmt::print("{} {}\n", name, value.get<std::uint64_t>());
}

void describe_count(CommandLine& line) {
  const auto options = std::make_shared<CountOptions>();
  Command& command = line.add(
      "count", "Measures", "Count what a Program takes at the functional level: the same on every computer",
      "Example:\n  csgsim_bench count traces/carburettor.csgt\n"
      "Segments and tiles of the picture; stretches, at whose ends threads meet; instructions carried out at tiles, of "
      "these linear ones, and open ones, which looked at words or lanes; how many of these; bit steps; longest and "
      "longest_...: the same at the tile that has most of them, of each stretch.");
  command.option("PROGRAM", options->program, "A Program file").required();
  command.option("--machine", options->machine, "Machine whose figures say what a bit step is; else the Program's own");
  command.flag("--json", options->json, "Print a JSON object");
  command.set_action([options] { count(*options); });
}

}  // namespace csgsim::bench

/// Measures the speed of the csgsim in the folder of this program.
int main(int argc, char** argv) {
  constexpr int bad_input = 1;
  constexpr int bad_usage = 2;
  try {
    csgsim::shell::CommandLine line("csgsim_bench: how fast csgsim itself is", "csgsim_bench");
    csgsim::bench::describe_measure(line);
    csgsim::bench::describe_count(line);
    line.run({argv, static_cast<std::size_t>(argc)});
    return 0;
  } catch (const csgsim::session::UsageError& error) {
    csgsim::report_line("csgsim_bench: " + std::string(error.what()));
    return bad_usage;
  } catch (const std::exception& error) {
    csgsim::report_line(error.what());
    return bad_input;
  }
}
