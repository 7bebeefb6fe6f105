// The page of a single run.
// Used by sim/session and sim/viewer.
#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"
#include "sim/report/configuration.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// The page of one run: its stats, its picture, and its drawing, for which the Program runs once more. All counts come
/// from the stats. With a model, the histories of pixels name its half-spaces.
Page run_page(const Json& stats, const observe::Frame& frame, const isa::Program& program,
              const machines::Machine& machine, const Context& context, const story::HalfspaceFinder* model = nullptr);

}  // namespace csgsim::report
