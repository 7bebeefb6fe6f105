#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"
#include "hw/machines/told.h"

namespace csgsim::machines {

/// The clocks of a frame and what they went into.
struct FrameTiming {
  std::uint64_t clocks = 0;           ///< from the frame's first until its picture stands in the memory that is shown
  std::uint64_t shown_clocks = 0;     ///< from its first until its last pixel is shown: the frame's latency
  std::uint64_t interval_clocks = 0;  ///< from one frame to the next, where the same is drawn again and again, and the
                                      ///< host keeps up
  std::uint64_t latency_clocks = 0;   ///< of `clocks`, for the last instruction to reach the pixels of a whole picture
  Account account;
  std::uint64_t host_clocks = 0;  ///< in which the host compiles the frame; 0 for an ideal one (hw/host)

  bool operator==(const FrameTiming&) const = default;
};

/// From one frame to the next: the host compiles a frame while the one before is drawn, so that the longer counts.
constexpr std::uint64_t paced_clocks(std::uint64_t interval_clocks, std::uint64_t host_clocks) {
  return interval_clocks < host_clocks ? host_clocks : interval_clocks;
}

/// A timing that does not tell when the frame is shown, or the interval (both 0), shows it when it is drawn, and then
/// begins the next.
FrameTiming with_pace(FrameTiming timing);

/// Of any kind, with_pace. `told`: of a run of the Program; without it no instruction is skipped, and of a kind that
/// asks for pixels (Kind::asks_for_pixels) the clocks are a bound that no run exceeds.
FrameTiming time_frame(const isa::Program& program, const Machine& machine, const Told& told = {});

}  // namespace csgsim::machines
