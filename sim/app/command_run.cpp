#include <memory>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "sim/app/commands.h"
#include "sim/app/paths.h"
#include "sim/app/program_input.h"
#include "sim/app/run_options.h"
#include "sim/app/run_outputs.h"

namespace csgsim::app {

void add_run(CommandLine& line) {
  struct Options {
    std::string program;
    std::string machine = "pixel-planes-4";
    RunOptions run;
  };
  const auto options = std::make_shared<Options>();
  Command command =
      line.add("run", "Run a Program file; the picture and the counts are those of its render",
               "Example:\n  csgsim run traces/carburettor.csgt -o carburettor.png --stats carburettor.json");
  command.option("PROGRAM", options->program, "The Program, .csgt or its text form").required();
  command.option("--machine", options->machine,
                 "A machine's name or its .toml file; it gets the array the Program is for");
  options->run.add_to(command);
  command.runs([options] {
    if (is_model(options->program))
      throw InputError(options->program + ": that is a model; use csgsim render " + shell_word(options->program));
    RunOutputs outputs(options->run, input_files({options->program}, {options->machine}));
    const isa::Program program = read_program(options->program);
    machines::Machine machine = kinds::load(options->machine);
    machines::adopt(machine, program);
    run_program(program, machine, options->run, outputs);
  });
}

}  // namespace csgsim::app
