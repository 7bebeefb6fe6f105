#pragma once

#include <string>

#include "hw/machines/machine.h"
#include "hw/systemc/wave_request.h"

namespace csgsim::app {

/// A GTKWave save file that shows a recorded waveform readably: texts as texts, depths as numbers, colours in
/// hexadecimal, one group a probed pixel.
std::string gtkwave_view(const kernel::WaveRequest& request, const std::string& waveform,
                         const machines::Machine& machine);

}  // namespace csgsim::app
