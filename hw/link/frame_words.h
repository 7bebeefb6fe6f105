#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include "hw/isa/link_word.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// For the FIFOs of links, though nobody calls it (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const LinkWord& /*word*/) { return stream; }

}  // namespace csgsim::isa

namespace csgsim::link {

/// A frame as it lies in the host's memory: for each segment its SegmentStart and its instructions, then FrameEnd.
struct FrameWords {
  std::vector<isa::LinkWord> words;
  /// For each instruction of the frame, and one more, the word at which the host goes on when all before it are over:
  /// its own first word, or that of the SegmentStart or FrameEnd that comes before it.
  std::vector<std::size_t> begins;
};

/// The Program, which has to be valid, in words of that many bits.
FrameWords frame_words(const isa::Program& program, unsigned link_width);

/// The same, of which only the words of the instructions with those numbers, and of what stands around them, are made:
/// `first` to before `end`. The others are 0.
FrameWords frame_words(const isa::Program& program, unsigned link_width, std::uint64_t first, std::uint64_t end);

}  // namespace csgsim::link
