#pragma once

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/regions.h"

namespace csgsim::emit {

/// What the options become where the machine divides the model itself: its strategy and its prunings. Throws InputError
/// for a strategy that it does not have, and for other prunings than all or just the divider's.
Options options_for(const machines::Division& division, const Options& options);

/// Adds to a Program that was compiled with such options, and with a colouring chosen, what the machine is sent in
/// place of the segments, and the tests that each takes there. Throws as make_display_model does.
void add_division(isa::Program& program, const machines::Division& division, const model::Tree& tree,
                  const facet::Geometry& geometry, const view::View& view, const machines::Machine& machine,
                  const Options& options);

}  // namespace csgsim::emit
