#pragma once

#include <nlohmann/json.hpp>

#include "sim/observe/stats_json.h"

namespace csgsim::sim {

/// Where the clocks of a machine that works on parts of the picture went; null for one that holds the whole of it.
nlohmann::ordered_json account_json(const Report& report);

/// Part of the whole, 0 of nothing.
double share(std::uint64_t part, std::uint64_t whole);

/// Of a scan-line array's cells, the part of the frame in which one works.
double cell_utilisation(const machines::LineAccount& account, const Report& report);

/// Of a pixel-square machine's renderers, the part of the frame in which one draws.
double renderer_utilisation(const machines::SquareAccount& account);

}  // namespace csgsim::sim
