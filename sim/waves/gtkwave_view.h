#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hw/machines/machine.h"
#include "hw/wave/request.h"
#include "sim/waves/record.h"

namespace csgsim::waves {

/// A save file for GTKWave that shows a recording from its first window on, the probed pixels first, each tap as it is
/// meant. `waveform`: the file, as the save file names it. `marked`: the clock at which the marker stands.
std::string gtkwave_view(const Recording& recording, std::span<const wave::Window> windows, std::uint64_t marked,
                         const std::string& waveform, const machines::Machine& machine);

}  // namespace csgsim::waves
