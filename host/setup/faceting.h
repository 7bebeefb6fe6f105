// Chooses which curved solids are drawn as facets, and how fine these are.
// Used by sim/session.
#pragma once

#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "host/setup/choices.h"
#include "host/view/camera.h"
#include "hw/machines/machine.h"

namespace csgsim::setup {

/// The faceting for the chosen camera. Converts a tolerance in pixels to model units at the point of the model nearest
/// to the eye, and prints the result. Prints a warning if fast spheres are chosen and other curved solids are drawn as
/// facets. Throws InputError if the machine or the scene allows facets only.
facet::Faceting faceting_for(const Choices& choices, const machines::Machine& machine, const model::Tree& tree);

/// The same for another camera, such as that of one of several frames, without printing the tolerance.
facet::Faceting faceting_at(const view::Camera& camera, const Choices& choices, const machines::Machine& machine,
                            const model::Tree& tree);

/// Whether the faceting depends on the camera.
bool depends_on_camera(const FacetingChoice& choice, const machines::Machine& machine);

}  // namespace csgsim::setup
