#pragma once

#include <optional>

#include "hw/machines/accounts.h"

namespace csgsim::observe {

/// Joules of a frame, of a machine whose figures say what it takes; none of others.
std::optional<double> frame_joules(const machines::Account& account);

}  // namespace csgsim::observe
