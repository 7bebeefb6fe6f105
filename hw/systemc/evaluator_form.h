// Forms of the multiplier trees' model.
// Used by hw/kinds, hw/pixel_planes, hw/pixel_square, sim/cycle, sim/session and sim/waves.
#pragma once

#include <cstdint>

namespace csgsim::systemc {

/// Model of a machine's multiplier trees. All forms have the same ports and clocks.
enum class EvaluatorForm : std::uint8_t {
  computed,  ///< register contents are computed from the coefficients that have entered
  stepped,   ///< simulated adder by adder, level by level
};

}  // namespace csgsim::systemc
