#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "hw/base/error.h"
#include "sim/app/commands/commands.h"
#include "sim/shell/advice.h"
#include "sim/shell/frames.h"
#include "sim/shell/model_options.h"
#include "sim/shell/near_faces_warning.h"
#include "sim/shell/options.h"
#include "sim/shell/run_options.h"
#include "sim/shell/run_outputs.h"
#include "sim/shell/settings/configuration.h"
#include "sim/shell/usage.h"
#include "sim/shell/verdict.h"
#include "sim/story/halfspaces.h"
#include "sim/studies/accuracy/measure.h"

namespace csgsim::app {

namespace {

struct Options {
  ModelOptions model;
  RunOptions run;
  bool check = false;
  std::optional<std::uint64_t> max_wrong_pixels;
  Turntable turntable;
};

/// Takes the cheapest z bits and fraction bits whose picture has at most so many wrong pixels, and says which.
void choose_settings(Options& options, const machines::Machine& machine) {
  const model::Tree tree = read_model(options.model);
  const facet::Faceting faceting = faceting_of(options.model, machine, tree);
  const view::Camera camera = camera_of(options.model, machine, tree, facet::make_geometry(tree, faceting));
  refuse_see_through(options.model, tree, camera);
  studies::Meter meter(tree, {camera}, machine, emit_options_of(options.model));
  const auto chosen =
      studies::cheapest(meter, studies::grid(sampling_of(options.model, machine), faceting), *options.max_wrong_pixels);
  if (!chosen) {
    throw InputError(
        fmt::format("no choice of --z-bits and --fraction-bits that fits the machine has at most {} wrong pixels; "
                    "allow more, or see csgsim accuracy",
                    *options.max_wrong_pixels));
  }
  options.model.z_bits = chosen->sampling.z_bits;
  options.model.fraction_bits = chosen->sampling.fraction_bits;
  fmt::print("{:<18}--z-bits {} --fraction-bits {}: the cheapest with at most {} wrong pixels\n", "chosen",
             options.model.z_bits, options.model.fraction_bits, *options.max_wrong_pixels);
}

void run_frames(const Options& options) {
  if (options.check) throw UsageError("--check", "is for one frame; leave out --frames");
  if (options.run.advice) throw UsageError("--advice", "is for one frame; leave out --frames");
  if (options.max_wrong_pixels) throw UsageError("--max-wrong-pixels", "is for one frame; leave out --frames");
  draw_frames(options.model, options.run, options.turntable, machine_of(options.model));
}

Advice advice_of(const Options& options, const CompiledModel& compiled, const machines::Machine& machine) {
  return {options.model.machine,
          options.run.advice,
          "csgsim render with --advice tries the machine's figures and the settings, and tells what each is worth",
          [&](const engine::RunResult& result) { return setting_knobs(compiled, options.model, machine, result); },
          {"csgsim accuracy tells what bits and facets cost in wrong pixels, csgsim sweep what memory buys"}};
}

void run(Options& options, const Command& command) {
  if (options.turntable.frames > 1) {
    if (command.watch().after) throw UsageError("--frames", "a sequence of frames has no stats to be compared with");
    return run_frames(options);
  }
  RunOutputs outputs(options.run, options.model.inputs());
  const machines::Machine machine = machine_of(options.model);
  if (options.max_wrong_pixels) choose_settings(options, machine);
  const CompiledModel compiled = compile_model(options.model, machine);
  warn_of_near_faces(compiled, options.model);
  Judge judge;
  if (options.check) {
    refuse_see_through(options.model, compiled.tree, compiled.camera);
    judge = [&](const observe::Frame& frame, nlohmann::ordered_json& json) {
      return verdict(compiled, options.model, frame, json);
    };
  }
  std::vector<std::filesystem::path> inputs = options.model.inputs();
  inputs.insert(inputs.end(), compiled.tree.imports.begin(), compiled.tree.imports.end());
  RunSubject subject{machine,       compiled.program, std::move(inputs),
                     compiled.hash, &compiled.camera, &options.model.scene_values()};
  std::optional<view::View> view;
  std::optional<story::HalfspaceFinder> halfspaces;
  if (options.run.report.asked()) {
    view = view::make_view(compiled.scene, compiled.tree, compiled.camera, sampling_of(options.model, machine));
    subject.halfspaces = &halfspaces.emplace(compiled.tree, compiled.scene, *view);
  }
  run_program(command, subject, options.run, outputs, advice_of(options, compiled, machine), judge);
}

}  // namespace

void add_render(CommandLine& line) {
  const auto options = std::make_shared<Options>();
  Command command =
      line.add("render", "Draw a CSG model on a machine and count what it takes",
               "Example:\n  csgsim render carburettor.csg -o carburettor.png --camera 220,-255,135,2,0,5 --stats "
               "carburettor.json\n"
               "  csgsim render carburettor.csg -o carburettor.png --projection perspective --level cycle");
  options->model.add_to(command);
  options->run.add_to(command);
  options->run.report.add_to(command);
  command.flag("--check", options->check, "Hold the picture against the exact one, and add what differs to the stats");
  command
      .option("--max-wrong-pixels", options->max_wrong_pixels,
              "Take the cheapest --z-bits and --fraction-bits with at most so many wrong pixels")
      .check(whole_number);
  command
      .option("--frames", options->turntable.frames,
              "Draw so many pictures, NAME_000.png and so on, and tell how many the machine draws a second")
      .between(1U, most_frames);
  command.option("--turn", options->turntable.degrees,
                 "Degrees that the camera turns about the vertical axis through its centre from one frame to the next");
  command.prints_summary();
  command.runs([options, command] { run(*options, command); });
}

}  // namespace csgsim::app
