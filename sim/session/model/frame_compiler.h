// Compiles a model for one camera after another.
// Used by sim/session.
#pragma once

#include <optional>
#include <vector>

#include "host/csg/kept_results.h"
#include "host/facet/faceting.h"
#include "host/view/camera.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// Compiles a model for one camera after another. The model is read once, and its half-spaces are computed once unless
/// they depend on the camera (setup::depends_on_camera). Each Program has the instructions that compile_model gives for
/// its camera; the host work that results of earlier frames replace is not counted again, and work for the model is
/// counted in the frame that does it, mostly the first. The machine has to outlive it.
class FrameCompiler {
 public:
  /// Reads the model. Throws as compile_model does.
  FrameCompiler(const ModelRequest& request, const machines::Machine& machine);

  /// The model with its half-spaces and the camera of the request.
  [[nodiscard]] const CompiledModel& model() const { return model_; }

  [[nodiscard]] isa::Program compile(const view::Camera& camera);

  /// The work that the last frame saved by reusing results of earlier frames.
  [[nodiscard]] const csg::ReuseCounts& reused() const { return kept_.reused(); }

 private:
  const machines::Machine& machine_;
  CompiledModel model_;
  std::optional<facet::Faceting> faceting_;  ///< only if it depends on the camera
  csg::KeptResults kept_;
};

}  // namespace csgsim::session
