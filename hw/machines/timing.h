#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// A skip_if_none that found no pixel enabled, so that the instructions it names were not carried out.
struct Skip {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;  ///< of the question within the segment

  constexpr bool operator==(const Skip&) const = default;
};

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

/// Of any kind, with_pace. `skips`: in program order, what the run skipped, which only the run tells.
FrameTiming time_frame(const isa::Program& program, const Machine& machine, std::span<const Skip> skips = {});

}  // namespace csgsim::machines
