#include "sim/session/model/frame_compiler.h"

#include <utility>

#include "sim/session/model/near_faces_warning.h"

namespace csgsim::session {

FrameCompiler::FrameCompiler(const ModelRequest& request, const machines::Machine& machine)
    : request_(request), machine_(machine), model_(facet_model(read_model_file(request), request, machine)) {
  warn_of_near_faces(model_, request);
}

isa::Program FrameCompiler::compile(const view::Camera& camera) {
  kept_.begin_frame();
  ModelRequest frame = request_;
  frame.frame_camera = camera;
  if (is_faceted_for_camera(request_, machine_)) {
    facet::Faceting faceting = faceting_of(frame, machine_, model_.tree);
    if (faceting != faceting_) {
      kept_.forget_geometry();
      model_.scene = facet::make_geometry(model_.tree, faceting);
    }
    faceting_ = std::move(faceting);
  }
  return compile_for_camera(camera, model_, frame, machine_, &kept_);
}

}  // namespace csgsim::session
