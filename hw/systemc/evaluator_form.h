#pragma once

#include <cstdint>

namespace csgsim::systemc {

/// How the multiplier trees of a machine are built: their ports and clocks are the same.
enum class EvaluatorForm : std::uint8_t {
  worked_out,  ///< what its registers hold is worked out of the coefficients that have entered
  stepped,     ///< adder by adder, level by level
};

}  // namespace csgsim::systemc
