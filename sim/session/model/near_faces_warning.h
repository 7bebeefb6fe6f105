// Warning about nearly coplanar faces of a model.
// Used by sim/session and sim/app.
#pragma once

#include "sim/session/model/compiled_model.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// Prints a one-line warning if faces of two nodes are nearly but not exactly coplanar (convex/near_faces.h).
void warn_of_near_faces(const CompiledModel& model, const ModelRequest& request);

}  // namespace csgsim::session
