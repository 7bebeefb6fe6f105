#include "sim/calls/render.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/prints.h"
#include "sim/shell/near_faces_warning.h"
#include "sim/shell/options.h"
#include "sim/shell/see_through.h"
#include "sim/shell/verdict.h"
#include "sim/studies/accuracy/measure.h"

namespace csgsim::calls {

void RenderOptions::add_to(Command& command) {
  model.add_to(command);
  run.add_to(command);
  run.report.add_to(command);
  command.flag("--check", check, "Hold the picture against the exact one, and add what differs to the stats");
  command
      .option("--max-wrong-pixels", max_wrong_pixels,
              "Take the cheapest --z-bits and --fraction-bits with at most so many wrong pixels")
      .check(whole_number);
}

namespace {

/// Takes the cheapest z bits and fraction bits whose picture has at most so many wrong pixels, and says which.
void choose_settings(RenderOptions& options, const machines::Machine& machine, const model::Tree& tree) {
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
  print_text(fmt::format("{:<18}--z-bits {} --fraction-bits {}: the cheapest with at most {} wrong pixels\n", "chosen",
                         options.model.z_bits, options.model.fraction_bits, *options.max_wrong_pixels));
}

}  // namespace

Compiled compile(RenderOptions& options, const InPlace& in_place) {
  machines::Machine machine = machine_of(options.model);
  ModelFile file = in_place.text ? read_model_text(options.model, *in_place.text) : read_model_file(options.model);
  if (options.max_wrong_pixels) choose_settings(options, machine, file.tree);
  CompiledModel model = compile_model(std::move(file), options.model, machine);
  warn_of_near_faces(model, options.model);
  std::vector<std::filesystem::path> inputs = options.model.inputs();
  inputs.insert(inputs.end(), model.tree.imports.begin(), model.tree.imports.end());
  return {std::move(machine), std::move(model), std::move(inputs), in_place.text.has_value()};
}

Judge judge_of(const RenderOptions& options, const Compiled& compiled) {
  if (!options.check) return {};
  refuse_see_through(options.model, compiled.model.tree, compiled.model.camera);
  return [&](const observe::Frame& frame, nlohmann::ordered_json& json) {
    return verdict(compiled.model, options.model, frame, json);
  };
}

Advice advice_of(const RenderOptions& options, const Compiled& compiled) {
  return {options.model.machine,
          options.run.advice,
          "csgsim render with --advice tries the machine's figures and the settings, and tells what each is worth",
          [&](const engine::RunResult& result) {
            return setting_knobs(compiled.model, options.model, compiled.machine, result);
          },
          {"csgsim accuracy tells what bits and facets cost in wrong pixels, csgsim sweep what memory buys"}};
}

}  // namespace csgsim::calls
