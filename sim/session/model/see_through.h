#pragma once

#include "host/emit/effect.h"
#include "host/emit/options.h"
#include "host/model/tree.h"
#include "host/view/camera.h"
#include "sim/session/model/model_request.h"

namespace csgsim::session {

/// An effect of what is drawn that lets something through; null if there is none.
const emit::EffectRow* see_through(const emit::Options& emit, const model::Tree& tree, const view::Camera& camera);

/// Throws InputError where what is seen through would be held against an exact picture, which knows opaque solids
/// alone.
void refuse_see_through(const ModelRequest& request, const model::Tree& tree, const view::Camera& camera);

}  // namespace csgsim::session
