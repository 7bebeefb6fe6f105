// Limits of the programs that draw plots.
// Used for gnuplot and fc-list.
#pragma once

#include <chrono>
#include <cstddef>

#include "sim/system/child_process.h"

namespace csgsim::plots {

/// Limits of gnuplot and fc-list. A plot takes one or two seconds, more if fontconfig has to scan thousands of fonts
/// first.
inline constexpr system::ChildLimits program_limits{.time = std::chrono::minutes(10),
                                                    .output = std::size_t{256} << 20U,
                                                    .errors = std::size_t{16} << 20U,
                                                    .memory = std::size_t{4} << 30U};

}  // namespace csgsim::plots
