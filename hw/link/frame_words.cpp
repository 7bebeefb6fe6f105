#include "hw/link/frame_words.h"

#include <fmt/format.h>

#include "hw/isa/wire.h"

namespace csgsim::isa {

std::ostream& operator<<(std::ostream& stream, const LinkWord& word) {
  return stream << fmt::format("{:016x}{:016x}{:016x}{:016x}", word.bits[3], word.bits[2], word.bits[1], word.bits[0]);
}

}  // namespace csgsim::isa

namespace csgsim::link {

FrameWords frame_words(const isa::Program& program, unsigned link_width) {
  FrameWords frame;
  const auto send = [&](const isa::Command& command) {
    isa::encode(command, link_width, [&](const isa::LinkWord& word) { frame.words.push_back(word); });
  };
  frame.begins.push_back(0);
  for (const isa::Segment& segment : program.segments) {
    send(isa::SegmentStart{segment.region});
    for (const isa::Instruction& instruction : segment.instructions) {
      send(instruction);
      frame.begins.push_back(frame.words.size());
    }
  }
  send(isa::FrameEnd{isa::frame_header(program).colour});
  return frame;
}

}  // namespace csgsim::link
