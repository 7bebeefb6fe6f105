#pragma once

#include <ostream>

#include "hw/isa/link_word.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// A word that a graphics processor puts on the ring: a command word for a renderer, or a header word of a square that
/// the frame buffer clears.
struct RingWord {
  isa::LinkWord command;
  PortWord header;
};

// Required by sc_fifo; never called (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const RingWord& /*word*/) { return stream; }

}  // namespace csgsim::pixel_square
