#pragma once

#include <cstdint>

#include "hw/machines/machine.h"
#include "sim/session/model/model_request.h"
#include "sim/session/run/run_request.h"

namespace csgsim::shell {

using namespace session;

inline constexpr std::uint32_t most_frames = 1000;

/// What a sequence of pictures shows.
struct Turntable {
  std::uint32_t frames = 1;
  double degrees = 0;  ///< that the camera turns from one frame to the next
};

/// Draws a sequence of frames, each a Program of its own, while the camera turns counterclockwise about the vertical
/// axis through its centre; NAME_000.png and so on for NAME.png. At the cycle level the machine draws them as a
/// sequence, and what is told of their pace is counted from that. Throws UsageError for outputs that a sequence has
/// not.
void draw_frames(const ModelRequest& model, const RunRequest& run, const Turntable& turntable,
                 const machines::Machine& machine);

}  // namespace csgsim::shell
