#pragma once

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "sim/observe/frame.h"
#include "sim/report/configuration.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// The page of one run: its stats file, its picture, and its drawing, for which it is run once more. The counts are
/// those of the stats, whatever keys they hold. With a model, stories of pixels name its half-spaces.
Page run_page(const Json& stats, const observe::Frame& frame, const isa::Program& program,
              const machines::Machine& machine, const Context& context, const story::HalfspaceFinder* model = nullptr);

}  // namespace csgsim::report
