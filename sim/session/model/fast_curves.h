// Selects the spheres that are drawn as circles and paraboloids.
// Used by model_request.cpp.
#pragma once

#include "host/emit/look.h"
#include "host/emit/options.h"
#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"

namespace csgsim::session {

/// Adds those spheres that can be drawn as fast spheres to `planar`. Prints a one-line warning if other curved solids
/// are drawn as facets. Throws InputError if the machine or the scene allows facets only.
facet::Faceting with_fast_spheres(facet::Faceting planar, const model::Tree& tree, const view::Camera& camera,
                                  const view::Sampling& sampling, const machines::Machine& machine,
                                  const emit::Options& options, const emit::Look& look);

}  // namespace csgsim::session
