// Finds effects that make surfaces transparent.
// Used by sim/session and sim/studies.
#pragma once

#include "host/emit/effect.h"
#include "host/emit/options.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// The first enabled effect that makes something transparent; null if there is none.
const emit::EffectRow* see_through(const emit::Options& emit, const model::Tree& tree, const view::Camera& camera);

/// Throws InputError if transparent parts would be compared with an exact picture, which supports opaque solids only.
void refuse_see_through(const ModelRequest& request, const model::Tree& tree, const view::Camera& camera);

}  // namespace csgsim::session
