#include "sim/calls/run.h"

#include <memory>

#include "sim/app/commands/commands.h"
#include "sim/shell/run_outputs.h"
#include "sim/shell/subject.h"

namespace csgsim::app {

void add_run(CommandLine& line) {
  const auto options = std::make_shared<calls::RunProgramOptions>();
  Command command =
      line.add("run", "Run a Program file; the picture and the counts are those of its render",
               "Example:\n  csgsim run traces/carburettor.csgt -o carburettor.png --stats carburettor.json\n"
               "  csgsim run traces/carburettor.csgt -o carburettor.png --checkpoint run.csgs --checkpoint-every 500\n"
               "  csgsim run traces/carburettor.csgt -o carburettor.png --resume run.csgs");
  options->add_to(command);
  command.prints_summary();
  command.runs([options, command] {
    refuse_model(options->program);
    calls::refuse_misuse(*options);
    RunOutputs outputs(options->run, options->files_read());
    const calls::Loaded loaded = calls::load(*options);
    run_program(command, loaded.subject(), options->run, outputs, calls::advice_of(*options, loaded.machine), {},
                options->checkpoints);
  });
}

}  // namespace csgsim::app
