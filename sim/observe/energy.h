// Energy of a frame.
// Used by sim/observe and sim/studies.
#pragma once

#include <optional>

#include "hw/machines/accounts.h"

namespace csgsim::observe {

/// Energy of a frame in joules; nothing if the machine's parameters do not define it.
std::optional<double> frame_joules(const machines::Account& account);

}  // namespace csgsim::observe
