#pragma once

#include <cstdint>
#include <ostream>

#include "hw/isa/program.h"

namespace csgsim::pixel_square {

/// Counts of a renderer's controller for an issued command. They are reported to run listeners, and model no hardware.
struct CommandAccount {
  enum class Kind : std::uint8_t { start, instruction, end };

  Kind kind = Kind::start;
  isa::Region region{};       ///< region of a square that starts
  std::uint64_t clocks = 0;   ///< clocks of an instruction
  std::uint64_t skipped = 0;  ///< number of following instructions that are skipped
};

// Required by sc_signal; never called (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const CommandAccount& /*account*/) { return stream; }

}  // namespace csgsim::pixel_square
