#pragma once

#include "host/emit/look.h"
#include "host/emit/options.h"
#include "host/facet/faceting.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"

namespace csgsim::session {

/// `planar` with those spheres that can be fast spheres. One line on standard error if other curved solids stay
/// facets. Throws InputError where there can be no surfaces but facets.
facet::Faceting with_fast_spheres(facet::Faceting planar, const model::Tree& tree, const view::Camera& camera,
                                  const view::Sampling& sampling, const machines::Machine& machine,
                                  const emit::Options& options, const emit::Look& look);

}  // namespace csgsim::session
