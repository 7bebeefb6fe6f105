#pragma once

#include <cstdint>
#include <functional>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

/// Tells the clocks that a Program takes.
using ClockCounter = std::function<std::uint64_t(const isa::Program&)>;

/// Compiles a model, as a view sees it, into a Program with a segment for each region that the machine works on. The
/// machine says how many memory bits there are, and whether it can be asked if any pixel is enabled; its picture is as
/// large as the view's. Where something is left to be chosen, `count` says what takes the fewest clocks; without it,
/// they are those if nothing is skipped. Throws InputError where the model does not fit the machine.
isa::Program compile(const model::Tree& tree, const facet::Geometry& geometry, view::View view,
                     const machines::Machine& machine, const Options& options = {}, const ClockCounter& count = {});

}  // namespace csgsim::emit
