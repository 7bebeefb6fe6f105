#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/progress.h"
#include "sim/observe/stats.h"
#include "sim/shell/lists.h"
#include "sim/shell/memory.h"
#include "sim/shell/model_options.h"
#include "sim/shell/options.h"
#include "sim/shell/paths.h"
#include "sim/shell/run_options.h"

namespace csgsim::app {

namespace {

/// What a level makes of a Program.
struct Outcome {
  observe::Frame frame;
  observe::Stats stats;
  std::uint64_t clocks = 0;
  double seconds = 0;

  [[nodiscard]] bool same(const Outcome& other) const {
    return clocks == other.clocks && stats == other.stats && frame.colour == other.frame.colour &&
           frame.depth == other.frame.depth && frame.owner == other.frame.owner;
  }
};

struct Options {
  ModelOptions model;
  std::string levels = "functional,cycle,reference";
  std::string progress = "auto";
};

Outcome run_level(const std::string& level, const isa::Program& program, const machines::Machine& machine, bool shows) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  std::optional<observe::ProgressObserver> progress;
  std::vector<engine::Observer*> observers{&frame, &stats};
  announce_memory(machine, program.shape, level);
  const std::unique_ptr<engine::Engine> engine = make_engine(machine, level, 1);
  observe::LongWork work = long_run(level);
  if (shows || level != "functional") {
    progress.emplace(program, machine).warn(work, shows);
    observers.push_back(&*progress);
  }
  const auto begin = std::chrono::steady_clock::now();
  const engine::RunResult result = engine->run(program, observers);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  Outcome outcome{std::move(frame).frame(), stats.stats(), result.clocks, seconds.count()};
  if (!result.scanned_out.empty()) outcome.frame.colour = result.scanned_out;
  return outcome;
}

void compare_levels(const Options& options) {
  const std::vector<std::string> levels = parse_names(options.levels, "level", level_names());
  const machines::Machine machine = machine_of(options.model);
  const isa::Program program = compile_model(options.model, machine).program;
  const machines::Size picture = machine.picture;
  fmt::print("{} at {} x {}\n{:<12}{:>12}{:>12}{:>16}{:>20}  {}\n", printable(shown_name(options.model.model)),
             picture.width, picture.height, "level", "clocks", "wall s", "clocks/s", "times " + levels.front(),
             "picture, depth, owner, counts");
  std::optional<Outcome> first;
  for (const std::string& level : levels) {
    std::fflush(stdout);  // what has been measured is seen while the next one runs
    const Outcome outcome = with_memory_for_run({&program, 1}, program.shape, [&] {
      return run_level(level, program, machine, shows_progress(options.progress));
    });
    if (!first) first = outcome;
    const bool same = outcome.same(*first);
    fmt::print("{:<12}{:>12}{:>12.3f}{:>16.0f}{:>20.1f}  {}\n", level, outcome.clocks, outcome.seconds,
               static_cast<double>(outcome.clocks) / outcome.seconds, outcome.seconds / first->seconds,
               same ? "equal" : "DIFFERENT");
    if (!same) throw std::logic_error("two levels differ");
  }
}

}  // namespace

void add_levels(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command =
      line.add("levels", "Run a model at every level: what fidelity costs in time, and that the results are equal",
               "Example:\n  csgsim levels thesis_fig_2_3.csg --size 256x256\n"
               "  csgsim levels carburettor.csg --levels functional,cycle");
  options->model.add_to(command);
  command
      .option("--levels", options->levels,
              "List of the levels at which it is run; the first is what others are held against")
      .list_of(level_names(), "level");
  add_progress(command, options->progress);
  command.prints_summary();
  command.runs([options] { compare_levels(*options); });
}

}  // namespace csgsim::app
