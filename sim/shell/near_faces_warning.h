#pragma once

#include "sim/shell/compiled_model.h"
#include "sim/shell/model_options.h"

namespace csgsim::shell {

/// One line on standard error if faces of two nodes are nearly in one plane, though not quite (convex/near_faces.h).
void warn_of_near_faces(const CompiledModel& model, const ModelOptions& options);

}  // namespace csgsim::shell
