// Save files for waveform viewers.
// Used by sim/waves and sim/app.
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

/// Contents of a recording, for viewer files.
struct Shown {
  const Recording& recording;
  std::span<const wave::Window> windows;
  std::uint64_t marked = 0;  ///< clock of the marker
  std::string waveform;      ///< the waveform file, as named in a save file
  const machines::Machine& machine;
};

/// A save file for GTKWave that shows a recording from its first window on: the probed pixels first, each tap in its
/// display format.
std::string gtkwave_view(const Shown& shown);

/// Commands for Surfer that show the same (docs.surfer-project.org, Commands); numbers keep its default format.
std::string surfer_view(const Shown& shown);

/// A viewer file beside the waveform, with its extension.
struct View {
  std::string_view ending;
  std::string (*text)(const Shown& shown);
};

inline constexpr auto views = std::to_array<View>({{".gtkw", gtkwave_view}, {".sucl", surfer_view}});

/// Clock period in picoseconds, rounded as in SystemC.
std::uint64_t clock_period_ps(const machines::Machine& machine);

/// The taps in the order of viewers: pixels first.
std::vector<const wave::Tap*> ordered_taps(const Recording& recording);

/// The part of the tap's name before the last dot: `controller` of `controller.state`.
std::string_view unit_name(const wave::Tap& tap);

}  // namespace csgsim::waves
