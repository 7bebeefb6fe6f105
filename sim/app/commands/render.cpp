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
  Turntable turntable;
};

void run_frames(const Options& options) {
  if (options.check) throw UsageError("--check", "is for one frame; leave out --frames");
  if (options.run.advice) throw UsageError("--advice", "is for one frame; leave out --frames");
  if (options.max_wrong_pixels) throw UsageError("--max-wrong-pixels", "is for one frame; leave out --frames");
  draw_frames(options.model, options.run, options.turntable, machine_of(options.model));
}

void run(Options& options, const OptionList& command) {
  if (options.turntable.frames > 1) {
    if (command.watch.after) throw UsageError("--frames", "a sequence of frames has no stats to compare");
    return run_frames(options);
  }
  RunOutputs outputs(options.run, options.model.inputs());
  const Compiled compiled = compile(options, studies::choose_bits);
  run_program(command, compiled.subject(options), options.run, outputs, advice_of(options, compiled),
              judge_of(options, compiled));
}

void add_render(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command& command =
      line.add("render", everyday_group, "Draw a CSG model on a simulated machine and report its clocks",
               "Example:\n  csgsim render carburettor.csg -o carburettor.png --camera 220,-255,135,2,0,5 --stats "
               "carburettor.json\n"
               "  csgsim render carburettor.csg -o carburettor.png --projection perspective --level cycle");
  options->add_to(command);
  command
      .option("--frames", options->turntable.frames,
              "Draw this number of pictures, NAME_000.png and so on, and report frames per second")
      .between(1U, max_frames);
  command.option("--turn", options->turntable.degrees,
                 "Degrees the camera turns between frames, about the vertical axis through its centre");
  add_verbose(command, options->run);
  command.prints_summary();
  command.runs([options, &command] { run(*options, command); });
}

}  // namespace

extern const CommandRow render_row{.name = "render", .add = add_render};

}  // namespace csgsim::app
