// The compiler: a model seen by a camera becomes a Program for a machine.
// Used by sim/csgsim.h, sim/session and sim/studies.
#pragma once

#include <cstdint>
#include <functional>

#include "host/csg/kept_results.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

/// Counts the clocks that a Program takes.
using ClockCounter = std::function<std::uint64_t(const isa::Program&)>;

/// Compiles a model, seen through a view, into a Program with one segment for each region that the machine works on.
/// The machine determines the number of memory bits and whether it has a global OR of E; its picture size must equal
/// the view's. If the strategy or colouring is automatic, the candidate with the fewest clocks by `count` is taken;
/// without `count`, the clocks are those of a run that skips nothing. `kept` has results of earlier frames of the model
/// and gets those of this one: they change the counts of host work, but no instruction. Throws InputError if the model
/// does not fit the machine.
isa::Program compile(const model::Tree& tree, const facet::Geometry& geometry, view::View view,
                     const machines::Machine& machine, const Options& options = {}, const ClockCounter& count = {},
                     csg::KeptResults* kept = nullptr);

}  // namespace csgsim::emit
