#include "sim/session/run/render.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "host/convex/near_faces.h"
#include "hw/base/error.h"
#include "sim/session/model/transparent_parts.h"
#include "sim/session/options/progress.h"
#include "sim/session/run/verdict.h"

namespace csgsim::session {

void RenderRequest::add_to(OptionList& options) {
  model.add_to(options);
  run.add_to(options);
  run.report.add_to(options);
  options.flag("--check", check, "Compare the picture with the exact one and add the differences to the stats");
  options.option("--max-wrong-pixels", max_wrong_pixels,
                 "Use the cheapest --z-bits and --fraction-bits with at most this number of wrong pixels");
}

Compiled compile(RenderRequest& request, const ChooseBits& choose, const ContentReplacement& in_place) {
  machines::Machine machine = machine_of(request.model);
  ModelFile file = read_model_file(request.model, in_place.text);
  if (request.max_wrong_pixels) choose(request, machine, file.tree);
  CompiledModel model = compile_model(std::move(file), choices_of(request.model, machine), machine);
  convex::warn_of_near_faces(model.tree, model.scene, request.model.snap);
  std::vector<std::filesystem::path> inputs = request.model.inputs();
  inputs.insert(inputs.end(), model.tree.imports.begin(), model.tree.imports.end());
  return {std::move(machine), std::move(model), std::move(inputs), in_place.text.has_value()};
}

Judge make_judge(const RenderRequest& request, const Compiled& compiled) {
  if (!request.check) return {};
  const CompiledModel& model = compiled.model;
  refuse_transparent_parts(model.choices.options, model.tree, model.camera);
  return [&](const observe::Frame& frame, nlohmann::ordered_json& json) { return verdict(model, frame, json); };
}

Advice advice_of(const RenderRequest& request, const Compiled& compiled) {
  return {request.model.machine,
          request.run.advice,
          "--advice tries machine parameters, settings and prunings",
          [&](const engine::RunResult& result) {
            return measure_setting_knobs(compiled.model, request.model, compiled.machine, result);
          },
          {"csgsim accuracy measures wrong pixels by bits and facets, csgsim sweep the benefit of memory"}};
}

}  // namespace csgsim::session
