// Clocks of a frame.
// Used by hw and sim.
#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/machines/run_outcome.h"

namespace csgsim::machines {

/// Clocks of a frame and their account.
struct FrameTiming {
  std::uint64_t clocks = 0;           ///< from the frame's first clock until its picture is in the displayed memory
  std::uint64_t shown_clocks = 0;     ///< from its first clock until its last pixel is shown: the frame's latency
  std::uint64_t interval_clocks = 0;  ///< from one frame to the next if the same frame is drawn repeatedly and the
                                      ///< host keeps up
  std::uint64_t latency_clocks = 0;   ///< part of `clocks`: time for the last instruction to reach all pixels
  Account account;
  std::uint64_t host_clocks = 0;        ///< clocks to compile the frame on the host; 0 for an ideal host (hw/host)
  std::uint64_t host_model_clocks = 0;  ///< clocks of the host for work done once per model; 0 for an ideal host

  bool operator==(const FrameTiming&) const = default;
};

/// Clocks per frame: the host compiles a frame while the previous one is drawn, so the longer time counts.
constexpr std::uint64_t paced_clocks(std::uint64_t interval_clocks, std::uint64_t host_clocks) {
  return interval_clocks < host_clocks ? host_clocks : interval_clocks;
}

/// Frames per second if the same frame is drawn repeatedly: the steady state, without the host's work for the model,
/// which is done once. 0 if a frame takes no time.
struct FrameRates {
  double hardware = 0;  ///< of the machine without its host: `frames_per_second` in stats and tables
  double hosted = 0;    ///< limited by the host too: `hosted_frames_per_second`

  bool operator==(const FrameRates&) const = default;
};

FrameRates frame_rates(std::uint64_t clock_hz, std::uint64_t interval_clocks, std::uint64_t host_clocks);

/// Fills in missing values: a frame without shown_clocks is shown when it is drawn, and one without interval_clocks is
/// followed by the next when it has been shown.
FrameTiming with_pace(FrameTiming timing);

/// Timing for a machine of any kind, completed by with_pace(). `outcome` comes from a run of the Program; without it no
/// instruction is skipped, and for a kind that depends on pixels (Kind::depends_on_pixels) the clocks are an upper
/// bound.
FrameTiming time_frame(const isa::Program& program, const Machine& machine, const RunOutcome& outcome = {});

}  // namespace csgsim::machines
