#include <filesystem>
#include <memory>
#include <vector>

#include "sim/app/commands/commands.h"
#include "sim/shell/advice.h"
#include "sim/shell/paths.h"
#include "sim/shell/program_of.h"
#include "sim/shell/read_by.h"
#include "sim/shell/run_options.h"
#include "sim/shell/run_outputs.h"
#include "sim/shell/settings/configuration.h"
#include "sim/shell/settings/sets.h"
#include "sim/shell/subject.h"

namespace csgsim::app {

namespace {

struct Options {
  std::string program;
  std::string machine;            ///< empty: the one that the Program names
  std::vector<std::string> sets;  ///< KEY=VALUE of a figure
  RunOptions run;
  CheckpointOptions checkpoints;
};

std::vector<std::filesystem::path> inputs_of(const Options& options) {
  if (options.machine.empty()) return input_files({options.program}, {});
  return input_files({options.program}, {options.machine});
}

/// Files that a checkpoint may not take the place of. The one that is resumed may be written again.
std::vector<std::filesystem::path> others(const Options& options) {
  std::vector<std::filesystem::path> files = inputs_of(options);
  for (const std::string& file : {options.run.picture, options.run.depth, options.run.owner, options.run.stats})
    if (!file.empty()) files.emplace_back(file);
  return files;
}

}  // namespace

void add_run(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command =
      line.add("run", "Run a Program file; the picture and the counts are those of its render",
               "Example:\n  csgsim run traces/carburettor.csgt -o carburettor.png --stats carburettor.json\n"
               "  csgsim run traces/carburettor.csgt -o carburettor.png --checkpoint run.csgs --checkpoint-every 500\n"
               "  csgsim run traces/carburettor.csgt -o carburettor.png --resume run.csgs");
  command.option("PROGRAM", options->program, "The Program, .csgt or its text form").required();
  command
      .option("--machine", options->machine,
              "A machine's name or its .toml file, in place of the one that the Program was compiled for; it gets "
              "the array the Program is for")
      .check(is_read_by(check_machine));
  add_figure_sets(command, options->sets, "the machine");
  options->run.add_to(command);
  options->checkpoints.add_to(command);
  command.prints_summary();
  command.runs([options, command] {
    refuse_model(options->program);
    refuse_scene_sets(options->sets);
    const std::vector<std::filesystem::path> inputs = inputs_of(*options);
    std::vector<std::filesystem::path> files = inputs;
    if (!options->checkpoints.resume.empty()) files.emplace_back(options->checkpoints.resume);
    RunOutputs outputs(options->run, files);
    options->checkpoints.check(options->run.level, others(*options));
    const isa::Program program = read_program(options->program);
    const machines::Machine machine = machine_for(program, options->program, options->machine, options->sets);
    const Advice advice{options->machine.empty() ? machine.name : options->machine, options->run.advice,
                        "csgsim run --advice tries the machine's figures, csgsim render --advice settings too"};
    run_program(command, {machine, program, inputs, {}}, options->run, outputs, advice, {}, options->checkpoints);
  });
}

}  // namespace csgsim::app
