// Template values for FPGA boards.
// Used by design.cpp.
#pragma once

#include <vector>

#include "sim/rtl/template.h"

namespace csgsim::rtl {

/// Wires of a design that a board connects.
struct BoardWires {
  unsigned colour_bits = 0;  ///< bits of a pixel
  unsigned scan_pixels = 0;  ///< pixels shown per clock
  bool has_line = false;     ///< the design has a serial line to the host instead of a Program in memory
};

/// Maximum bits per channel on a board: enough for a small video DAC.
inline constexpr unsigned max_channel_bits = 4;

/// Adds the fillings of board templates that concern wires: names with BOARD_, and CHANNEL_BITS.
void add_board(std::vector<Filling>& fillings, const BoardWires& wires);

}  // namespace csgsim::rtl
