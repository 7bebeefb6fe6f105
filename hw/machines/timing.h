#pragma once

#include <cstdint>

#include "hw/isa/program.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// The clocks of a frame and what they went into.
struct FrameTiming {
  std::uint64_t clocks = 0;
  Account account;

  bool operator==(const FrameTiming&) const = default;
};

/// Of any kind.
FrameTiming time_frame(const isa::Program& program, const Machine& machine);

/// Of a machine that holds the whole picture: its instructions follow back to back.
FrameTiming time_whole(const isa::Program& program, const Machine& machine);

/// Of a scan-line array: worked out from the packets of each line (hw/scan_line counts the same).
FrameTiming time_lines(const isa::Program& program, const Machine& machine);

/// Of a pixel-square machine: worked out from the clocks of each instruction (hw/pixel_square counts the same).
FrameTiming time_squares(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
