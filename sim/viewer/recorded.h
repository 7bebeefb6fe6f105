#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>

#include "hw/isa/program.h"
#include "sim/system/child_process.h"

namespace csgsim::viewer {

/// What `csgsim wave` prints of the Program, with these options besides its name and its output: recorded in a process
/// of its own, since SystemC elaborates once a process. Throws InputError with what that says, or where it takes longer
/// than three minutes, or prints more than 512 MB.
std::string recorded(const isa::Program& program, std::span<const std::string> options);

/// The limits of that run of csgsim wave.
inline constexpr system::ChildLimits wave_limits{
    .time = std::chrono::minutes(3), .output = std::size_t{512} << 20U, .errors = 1U << 16U};

/// The same by the program of that name.
std::string recorded_by(const std::string& csgsim, const isa::Program& program, std::span<const std::string> options,
                        const system::ChildLimits& limits = wave_limits);

}  // namespace csgsim::viewer
