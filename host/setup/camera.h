// Chooses the camera of a picture.
// Used by faceting.cpp and sim/session.
#pragma once

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/setup/choices.h"
#include "hw/machines/machine.h"

namespace csgsim::setup {

/// The camera for a picture of the model. If it shows the whole model, or no camera is given, it depends on the model's
/// extent (convex/extent.h).
view::Camera camera_for(const CameraChoice& choice, const machines::Size& picture, const model::Tree& tree,
                        const facet::Geometry& scene);

}  // namespace csgsim::setup
