// A frame as words of a link.
// Used by hw/bit_serial_memory, hw/pixel_square, hw/scan_line and sim/rtl.
#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// Required by sc_fifo; never called (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const LinkWord& /*word*/) { return stream; }

}  // namespace csgsim::isa

namespace csgsim::link {

/// A frame in the host's memory: for each segment a SegmentStart and its instructions, then FrameEnd.
struct FrameWords {
  std::vector<isa::LinkWord> words;
  /// For each instruction of the frame, and for the end of the frame: the index of the word at which the host continues
  /// after all previous instructions. This is the instruction's first word, or that of a SegmentStart or FrameEnd
  /// before it.
  std::vector<std::size_t> begins;
};

/// The words of a valid Program for a link of `link_width` bits.
FrameWords frame_words(const isa::Program& program, unsigned link_width);

/// Like the function above, but the words of instructions outside [first_instruction, end_instruction) are 0.
FrameWords frame_words(const isa::Program& program, unsigned link_width, std::uint64_t first_instruction,
                       std::uint64_t end_instruction);

}  // namespace csgsim::link
