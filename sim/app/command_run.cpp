#include <memory>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/app/commands.h"
#include "sim/app/paths.h"
#include "sim/app/program_input.h"
#include "sim/app/run_options.h"
#include "sim/app/run_outputs.h"

namespace csgsim::app {

void add_run(CLI::App& app) {
  struct Options {
    std::string program;
    std::string machine = "pixel-planes-4";
    RunOptions run;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *app.add_subcommand("run", "Run a Program file; the picture and the counts are those of its render");
  command.footer("Example:\n  csgsim run traces/carburettor.csgt -o carburettor.png --stats carburettor.json");
  command.add_option("PROGRAM", options->program, "The Program, .csgt or its text form")->required();
  command
      .add_option("--machine", options->machine,
                  "A machine's name or its .toml file; it gets the array the Program is for")
      ->capture_default_str();
  options->run.add_to(command);
  command.callback([options] {
    if (is_model(options->program))
      throw InputError(options->program + ": that is a model; use csgsim render " + shell_word(options->program));
    RunOutputs outputs(options->run, input_files({options->program}, {options->machine}));
    const isa::Program program = read_program(options->program);
    machines::Machine machine = machines::load(options->machine);
    machines::adopt(machine, program);
    run_program(program, machine, options->run, outputs);
  });
}

}  // namespace csgsim::app
