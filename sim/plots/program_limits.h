#pragma once

#include <chrono>
#include <cstddef>

#include "sim/system/child_process.h"

namespace csgsim::plots {

/// Of gnuplot, and of fc-list: a plot takes a second or two, and longer where fontconfig has to find thousands of fonts
/// first.
inline constexpr system::ChildLimits program_limits{.time = std::chrono::minutes(10),
                                                    .output = std::size_t{256} << 20U,
                                                    .errors = std::size_t{16} << 20U,
                                                    .memory = std::size_t{4} << 30U};

}  // namespace csgsim::plots
