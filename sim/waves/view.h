#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/wave/request.h"
#include "sim/waves/record.h"

namespace csgsim::waves {

/// What a file shows, for viewers.
struct Shown {
  const Recording& recording;
  std::span<const wave::Window> windows;
  std::uint64_t marked = 0;  ///< clock at which the marker stands
  std::string waveform;      ///< the file, as a save file names it
  const machines::Machine& machine;
};

/// A save file for GTKWave that shows a recording from its first window on, the probed pixels first, each tap as it is
/// meant.
std::string gtkwave_view(const Shown& shown);

/// Commands for Surfer that show the same (docs.surfer-project.org, Commands); numbers stay as it shows them.
std::string surfer_view(const Shown& shown);

/// A file beside the waveform, by the ending of its name.
struct View {
  std::string_view ending;
  std::string (*text)(const Shown& shown);
};

inline constexpr auto views = std::to_array<View>({{".gtkw", gtkwave_view}, {".sucl", surfer_view}});

/// Picoseconds a clock, rounded as SystemC does.
std::uint64_t period_of(const machines::Machine& machine);

/// The taps as viewers list them: pixels first.
std::vector<const wave::Tap*> listed(const Recording& recording);

/// `controller` of `controller.state`.
std::string_view part_of(const wave::Tap& tap);

}  // namespace csgsim::waves
