#pragma once

#include <vector>

#include "sim/rtl/template.h"

namespace csgsim::rtl {

/// What a board has to connect of a design.
struct BoardWires {
  unsigned colour_bits = 0;  ///< of a pixel
  unsigned scan_pixels = 0;  ///< that are shown in a clock
  bool has_line = false;     ///< a serial line to the host, in place of a Program in memory
};

/// Bits of each channel that leave a board, at most: what a small converter of video takes.
inline constexpr unsigned most_channel_bits = 4;

/// Adds what templates of boards say of the wires: names with BOARD_ and CHANNEL_BITS.
void add_board(std::vector<Filling>& fillings, const BoardWires& wires);

}  // namespace csgsim::rtl
