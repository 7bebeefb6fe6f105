// Compilation for machines that divide the model themselves.
// Used by the compiler and sim/viewer.
#pragma once

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/regions.h"

namespace csgsim::emit {

/// The options for a machine that divides the model itself: its strategy and its prunings. Throws InputError for
/// another strategy, and for prunings that are neither the default nor the divider's.
Options options_for_division(const machines::Division& division, const Options& options);

/// Adds the display model, which the machine receives in place of the segments, and the counts of the divider's work
/// for each segment. The Program must have been compiled with the options of options_for_division and a fixed
/// colouring. Throws as make_display_model does.
void add_division(isa::Program& program, const machines::Division& division, const model::Tree& tree,
                  const facet::Geometry& geometry, const view::View& view, const machines::Machine& machine,
                  const Options& options);

}  // namespace csgsim::emit
