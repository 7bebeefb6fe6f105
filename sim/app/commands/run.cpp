#include <memory>

#include "sim/app/commands/commands.h"
#include "sim/session/model/subject.h"
#include "sim/session/run/run_file.h"
#include "sim/session/run/run_outputs.h"
#include "sim/shell/run_program.h"

namespace csgsim::app {

namespace {

void add_run(CommandLine& line) {
  const auto options = std::make_shared<ProgramRequest>();
  Command& command =
      line.add("run", run_group, "Run a Program file and write the picture and counts as csgsim render does",
               "Example:\n  csgsim run traces/carburettor.csgt -o carburettor.png --stats carburettor.json\n"
               "  csgsim run traces/carburettor.csgt -o carburettor.png --checkpoint run.csgs --checkpoint-every 500\n"
               "  csgsim run traces/carburettor.csgt -o carburettor.png --resume run.csgs");
  options->add_to(command);
  add_verbose_option(command, options->run);
  command.add_quiet_option();
  command.set_action([options, &command] {
    refuse_model(options->program);
    refuse_misuse(*options);
    RunOutputs outputs(options->run, options->files_read());
    const LoadedProgram loaded = load(*options);
    run_program(command, loaded.subject(), options->run, outputs, advice_of(*options, loaded.machine), {},
                options->checkpoints);
  });
}

}  // namespace

extern const CommandRow run_row{.name = "run", .add = add_run};

}  // namespace csgsim::app
