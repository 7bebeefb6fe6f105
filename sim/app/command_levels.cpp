#include <fmt/format.h>

#include <array>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <utility>

#include "hw/base/text.h"
#include "sim/app/commands.h"
#include "sim/app/memory.h"
#include "sim/app/model_options.h"
#include "sim/engine/engine.h"
#include "sim/observe/frame.h"
#include "sim/observe/stats.h"

namespace csgsim::app {

namespace {

/// What a level makes of a Program.
struct Outcome {
  sim::Frame frame;
  sim::Stats stats;
  std::uint64_t clocks = 0;
  double seconds = 0;

  [[nodiscard]] bool same(const Outcome& other) const {
    return clocks == other.clocks && stats == other.stats && frame.colour == other.frame.colour &&
           frame.depth == other.frame.depth && frame.owner == other.frame.owner;
  }
};

Outcome run_level(sim::Engine& engine, const isa::Program& program) {
  sim::FrameObserver frame(program);
  sim::StatsObserver stats(program);
  const std::array<sim::Observer*, 2> observers{&frame, &stats};
  const auto begin = std::chrono::steady_clock::now();
  const sim::RunResult result = engine.run(program, observers);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  Outcome outcome{std::move(frame).frame(), stats.stats(), result.clocks, seconds.count()};
  if (!result.scanned_out.empty()) outcome.frame.colour = result.scanned_out;
  return outcome;
}

void compare_levels(const ModelOptions& options) {
  const machines::Machine machine = machine_of(options);
  const isa::Program program = compile_model(options, machine).program;
  const machines::Size picture = machine.picture;
  const std::array<std::unique_ptr<sim::Engine>, 3> engines{
      sim::make_functional_engine(machine), sim::make_cycle_engine(machine), sim::make_reference_engine(machine)};
  fmt::print("{} at {} x {}\n{:<12}{:>12}{:>12}{:>16}{:>20}  {}\n", printable(options.model), picture.width,
             picture.height, "level", "clocks", "wall s", "clocks/s", "times functional",
             "picture, depth, owner, counts");
  Outcome first;
  for (const std::unique_ptr<sim::Engine>& engine : engines) {
    const Outcome outcome =
        with_memory_for_run({&program, 1}, program.shape, [&] { return run_level(*engine, program); });
    if (engine == engines.front()) first = outcome;
    const bool same = outcome.same(first);
    fmt::print("{:<12}{:>12}{:>12.3f}{:>16.0f}{:>20.1f}  {}\n", engine->level(), outcome.clocks, outcome.seconds,
               static_cast<double>(outcome.clocks) / outcome.seconds, outcome.seconds / first.seconds,
               same ? "equal" : "DIFFERENT");
    if (!same) throw std::logic_error("two levels differ");
  }
}

}  // namespace

void add_levels(CommandLine& line) {
  const auto options = std::make_shared<ModelOptions>();
  Command command =
      line.add("levels", "Run a model at every level: what fidelity costs in time, and that the results are equal",
               "Example:\n  csgsim levels thesis_fig_2_3.csg --size 256x256");
  options->add_to(command);
  command.runs([options] { compare_levels(*options); });
}

}  // namespace csgsim::app
