#include "sim/session/run/verdict.h"

#include <fmt/format.h>

#include "hw/isa/facts.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "sim/judges/truth.h"
#include "sim/session/model/transparent_parts.h"

namespace csgsim::session {

std::string verdict(const CompiledModel& compiled, const observe::Frame& frame, nlohmann::ordered_json& json) {
  refuse_transparent_parts(compiled.choices.options, compiled.tree, compiled.camera);
  const isa::Program& program = compiled.program;
  const judges::Truth truth = judges::exact_truth(compiled.tree, compiled.scene, compiled.camera, program.shape.width,
                                                  program.shape.height, program.facts->depth_scale);
  const judges::Explainer explainer(compiled.tree, compiled.scene, compiled.camera, program);
  const judges::Errors errors = judges::judge(truth, frame, program, explainer);
  json = {{"wrong", errors.wrong()},
          {"wrong_silhouette", errors.silhouette},
          {"wrong_owner", errors.owner},
          {"wrong_depth", errors.depth},
          {"explained", errors.explained},
          {"unexplained", errors.unexplained},
          {"covered", errors.covered},
          {"depth_max", errors.model_units.max},
          {"depth_p999", errors.model_units.p999},
          {"depth_max_steps", errors.steps.max},
          {"depth_p999_steps", errors.steps.p999}};
  return fmt::format("{:<18}{}\n", "accuracy", judges::to_text(errors));
}

}  // namespace csgsim::session
