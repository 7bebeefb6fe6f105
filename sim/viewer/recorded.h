// Records waveforms in a separate csgsim process.
// Used by sim/viewer and sim/web.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <string>

#include "hw/isa/program.h"
#include "sim/system/child_process.h"

namespace csgsim::viewer {

/// Output of `csgsim wave` for the Program with these options. It runs in a separate process, since SystemC allows one
/// elaboration per process. Throws InputError with the message of that process, or if it exceeds three
/// minutes or 512 MB of output.
std::string record_wave(const isa::Program& program, std::span<const std::string> options);

/// Limits of that process.
inline constexpr system::ChildLimits wave_limits{
    .time = std::chrono::minutes(3), .output = std::size_t{512} << 20U, .errors = 1U << 16U};

/// As record_wave(), but runs the csgsim executable at the path `csgsim`.
std::string record_wave_with(const std::string& csgsim_path, const isa::Program& program,
                             std::span<const std::string> options, const system::ChildLimits& limits = wave_limits);

}  // namespace csgsim::viewer
