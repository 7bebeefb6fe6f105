#include "sim/session/run/render.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/app/commands/commands.h"
#include "sim/session/options/usage.h"
#include "sim/session/run/run_outputs.h"
#include "sim/shell/frames.h"
#include "sim/shell/run_program.h"
#include "sim/studies/accuracy/choose_bits.h"

namespace csgsim::app {

namespace {

struct Options : RenderRequest {
  FramesRequest frames;
};

void run(Options& options, const OptionList& command) {
  if (options.frames.is_asked()) {
    if (command.watch.after)
      throw UsageError("--frames", "a sequence of frames cannot be rerun; render each frame with its camera");
    return run_frames(command, options, options.frames);
  }
  RunOutputs outputs(options.run, options.model.inputs());
  const Compiled compiled = compile(options, studies::choose_bits);
  run_program(command, compiled.subject(options), options.run, outputs, advice_of(options, compiled),
              make_judge(options, compiled));
}

void add_render(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("render", everyday_group, "Draw a CSG model on a simulated machine and report its clocks",
               "Example:\n  csgsim render carburettor.csg -o carburettor.png --camera 220,-255,135,2,0,5 --stats "
               "carburettor.json\n"
               "  csgsim render carburettor.csg -o carburettor.png --projection perspective --level cycle\n"
               "  csgsim render -D teeth=24 gear.scad -o gear.png\n"
               "  csgsim render carburettor.csg -o carburettor.gif --frames 60 --orbit 360");
  options->add_to(command);
  options->frames.add_to(command);
  add_verbose_option(command, options->run);
  command.add_quiet_option();
  command.set_action([options, &command] { run(*options, command); });
}

}  // namespace

extern const CommandRow render_row{.name = "render", .add = add_render};

}  // namespace csgsim::app
