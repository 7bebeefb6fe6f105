#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/base/text.h"
#include "sim/app/commands/commands.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/paths.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/memory.h"
#include "sim/session/run/run_request.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelRequest model;
  std::string levels = "functional,cycle,reference";
  std::string progress = "auto";
};

bool are_equal(const DrawnRun& one, const DrawnRun& other) {
  return one.result.clocks == other.result.clocks && one.stats == other.stats &&
         one.frame.colour == other.frame.colour && one.frame.depth == other.frame.depth &&
         one.frame.owner == other.frame.owner;
}

void compare_levels(const Options& options) {
  const std::vector<std::string> levels = parse_names(options.levels, "level", level_names());
  const machines::Machine machine = machine_of(options.model);
  const isa::Program program = compile_model(options.model, machine).program;
  const machines::Size picture = machine.picture;
  fmt::print("{} at {} x {}\n{:<12}{:>12}{:>12}{:>16}{:>20}  {}\n", printable(shown_name(options.model.model)),
             picture.width, picture.height, "level", "clocks", "wall s", "clocks/s", "wall / " + levels.front(),
             "picture, depth, owner, counts");
  std::optional<DrawnRun> first;
  for (const std::string& level : levels) {
    std::fflush(stdout);  // finished rows are visible while the next level runs
    announce_memory(machine, program.shape, level);
    const DrawnRun drawn = draw(program, machine, level, shows_progress(options.progress));
    if (!first) first = drawn;
    const bool same = are_equal(drawn, *first);
    const auto rate = static_cast<std::uint64_t>(static_cast<double>(drawn.result.clocks) / drawn.seconds);
    fmt::print("{:<12}{:>12}{:>12.3f}{:>16}{:>20.1f}  {}\n", level, grouped(drawn.result.clocks), drawn.seconds,
               grouped(rate), drawn.seconds / first->seconds, same ? "equal" : "DIFFERENT");
    if (!same) throw std::logic_error("two levels differ");
  }
}

void add_levels(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("levels", study_group, "Run a model at every level, compare run times and check that results are equal",
               "Example:\n  csgsim levels thesis_fig_2_3.csg --size 256x256\n"
               "  csgsim levels carburettor.csg --levels functional,cycle");
  options->model.add_to(command);
  command.option("--levels", options->levels, "Comma-separated levels to run; the others are compared with the first")
      .list_of(level_names(), "level");
  add_progress_option(command, options->progress);
  command.add_quiet_option();
  command.set_action([options] { compare_levels(*options); });
}

}  // namespace

extern const CommandRow levels_row{.name = "levels", .add = add_levels};

}  // namespace csgsim::app
