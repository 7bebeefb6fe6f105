#pragma once

#include "host/emit/options.h"
#include "host/facet/scene.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

/// Compiles a scene, as a view sees it, into a Program with a segment for each region that the machine works on. The
/// machine says how many memory bits there are, and, where something is left to be chosen, what takes the fewest
/// clocks; its picture is as large as the view's. Throws InputError where the model does not fit the machine.
isa::Program compile(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
                     const machines::Machine& machine, const Options& options = {});

}  // namespace csgsim::emit
