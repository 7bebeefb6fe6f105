#include "sim/session/model/frame_compiler.h"

#include <utility>

#include "host/convex/near_faces.h"
#include "host/setup/faceting.h"

namespace csgsim::session {

FrameCompiler::FrameCompiler(const ModelRequest& request, const machines::Machine& machine)
    : machine_(machine), model_(facet_model(request, machine)) {
  convex::warn_of_near_faces(model_.tree, model_.scene, request.snap);
}

isa::Program FrameCompiler::compile(const view::Camera& camera) {
  kept_.begin_frame();
  if (setup::depends_on_camera(model_.choices.faceting, machine_)) {
    facet::Faceting faceting = setup::faceting_at(camera, model_.choices, machine_, model_.tree);
    if (faceting != faceting_) {
      kept_.forget_geometry();
      model_.scene = facet::make_geometry(model_.tree, faceting);
    }
    faceting_ = std::move(faceting);
  }
  return compile_for_camera(camera, model_, machine_, &kept_);
}

}  // namespace csgsim::session
