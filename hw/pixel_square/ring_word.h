#pragma once

#include <ostream>

#include "hw/isa/link_word.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// What a graphics processor puts on the ring: a word of commands for a renderer, or one of the header of a square that
/// the frame buffer clears.
struct RingWord {
  isa::LinkWord command;
  PortWord header;
};

// Which nobody calls (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const RingWord& /*word*/) { return stream; }

}  // namespace csgsim::pixel_square
