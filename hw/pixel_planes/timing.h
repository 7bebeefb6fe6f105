#pragma once

#include <cstdint>
#include <span>

#include "hw/machines/timing.h"

namespace csgsim::pixel_planes {

/// Levels of registers of a tree of ORs with that fan-in over so many lines; 0 where the fan-in is 0.
std::uint32_t or_levels(std::uint64_t lines, std::uint32_t fan_in);

/// Clocks from one frame to the next with one buffer, where drawing takes so many, and so many pass in the scan-out
/// until the last pixel has been shown and until the last row has been latched. The next frame begins in the clock
/// after that; its scan-out waits until the row has been shown.
std::uint64_t interval_clocks(std::uint64_t drawing, std::uint64_t shown, std::uint64_t latched);

/// As bit_serial_clocks; a question waits for the levels of the global OR too.
std::uint64_t instruction_clocks(const isa::Instruction& instruction, const machines::Machine& machine);

/// A frame of a machine that holds the whole picture, from the clock in which the controller asks for it (the modules
/// count the same).
machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 std::span<const machines::Skip> skips);

}  // namespace csgsim::pixel_planes
