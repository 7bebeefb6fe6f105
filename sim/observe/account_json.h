// A machine's clock account as JSON.
// Used by stats_json.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hw/machines/accounts.h"

namespace csgsim::observe {

/// Counts and shares by name, then `parts`: the clocks of each unit by activity.
nlohmann::ordered_json account_json(const machines::Account& account);

}  // namespace csgsim::observe
