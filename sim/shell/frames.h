// Draws several frames with progress and a printed summary.
// Used by sim/app.
#pragma once

#include "sim/session/run/frames.h"

namespace csgsim::shell {

using namespace session;

/// Draws the frames, shows their progress on standard error if requested, and prints a line of summary.
void run_frames(const OptionList& options, const RenderRequest& request, const FramesRequest& wanted);

}  // namespace csgsim::shell
