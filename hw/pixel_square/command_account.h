#pragma once

#include <cstdint>
#include <ostream>

#include "hw/isa/program.h"

namespace csgsim::pixel_square {

/// What a renderer's controller counted for a command that it put on the wires. For who watches: no hardware reads it.
struct CommandAccount {
  enum class Kind : std::uint8_t { start, instruction, end };

  Kind kind = Kind::start;
  isa::Region region{};       ///< of a square that starts
  std::uint64_t clocks = 0;   ///< of an instruction
  std::uint64_t skipped = 0;  ///< instructions after it that are not carried out
};

// Which nobody calls (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const CommandAccount& /*account*/) { return stream; }

}  // namespace csgsim::pixel_square
