// Draws a sequence of frames with a turning camera.
// Used by sim/app.
#pragma once

#include <cstdint>

#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/session/run/run_request.h"

namespace csgsim::shell {

using namespace session;

inline constexpr std::uint32_t max_frames = 1000;

/// A sequence of pictures with a turning camera.
struct Turntable {
  std::uint32_t frames = 1;
  double degrees = 0;  ///< rotation of the camera from one frame to the next
};

/// Draws a sequence of frames, each from its own Program, while the camera turns counterclockwise about the vertical
/// axis through its centre. The files are NAME_000.png and so on for NAME.png. At the cycle level the machine draws the
/// frames as a sequence, and the reported frame rate includes their overlap. Throws UsageError for outputs that a
/// sequence does not support.
void draw_frames(const ModelRequest& model, const RunRequest& run, const Turntable& turntable,
                 const machines::Machine& machine);

}  // namespace csgsim::shell
