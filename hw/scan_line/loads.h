#pragma once

#include <vector>

#include "hw/machines/load.h"
#include "hw/machines/timing.h"

namespace csgsim::scan_line {

/// As machines::loads, of the account that this kind tells.
std::vector<machines::Load> loads(const machines::FrameTiming& timing);

}  // namespace csgsim::scan_line
