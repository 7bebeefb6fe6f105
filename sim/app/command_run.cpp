#include <filesystem>
#include <memory>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "sim/app/commands.h"
#include "sim/app/paths.h"
#include "sim/app/program_input.h"
#include "sim/app/run_options.h"
#include "sim/app/run_outputs.h"

namespace csgsim::app {

namespace {

struct Options {
  std::string program;
  std::string machine = "pixel-planes-4";
  RunOptions run;
  CheckpointOptions checkpoints;
};

/// Files that a checkpoint may not take the place of. The one that is resumed may be written again.
std::vector<std::filesystem::path> others(const Options& options) {
  std::vector<std::filesystem::path> files = input_files({options.program}, {options.machine});
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
  command.option("--machine", options->machine,
                 "A machine's name or its .toml file; it gets the array the Program is for");
  options->run.add_to(command);
  options->checkpoints.add_to(command);
  command.prints_summary();
  command.runs([options] {
    if (is_model(options->program))
      throw InputError(options->program + ": that is a model; use csgsim render " + shell_word(options->program));
    std::vector<std::filesystem::path> files = input_files({options->program}, {options->machine});
    if (!options->checkpoints.resume.empty()) files.emplace_back(options->checkpoints.resume);
    RunOutputs outputs(options->run, files);
    options->checkpoints.check(options->run.level, others(*options));
    const isa::Program program = read_program(options->program);
    machines::Machine machine = kinds::load(options->machine);
    machines::adopt(machine, program);
    run_program(program, machine, options->run, outputs, {}, options->checkpoints);
  });
}

}  // namespace csgsim::app
