// Refuses transparent parts where pictures are compared with exact ones.
// Used by sim/session and sim/studies.
#pragma once

#include "host/emit/options.h"
#include "host/model/tree.h"
#include "host/view/camera.h"

namespace csgsim::session {

/// Throws InputError if transparent parts would be compared with an exact picture, which supports opaque solids only.
void refuse_transparent_parts(const emit::Options& options, const model::Tree& tree, const view::Camera& camera);

}  // namespace csgsim::session
