#include "hw/link/frame_words.h"

#include <limits>

#include "hw/isa/wire.h"

namespace csgsim::link {

FrameWords frame_words(const isa::Program& program, unsigned link_width) {
  return frame_words(program, link_width, 0, std::numeric_limits<std::uint64_t>::max());
}

FrameWords frame_words(const isa::Program& program, unsigned link_width, std::uint64_t first_instruction,
                       std::uint64_t end_instruction) {
  FrameWords frame;
  const auto send = [&](const isa::Command& command) {
    isa::encode(command, link_width, [&](const isa::LinkWord& word) { frame.words.push_back(word); });
  };
  std::uint64_t number = 0;
  frame.begins.push_back(0);
  for (const isa::Segment& segment : program.segments) {
    send(isa::SegmentStart{segment.region});
    for (const isa::Instruction& instruction : segment.instructions) {
      if (number >= first_instruction && number < end_instruction) {
        send(instruction);
      } else {
        frame.words.resize(frame.words.size() + isa::wire_words(instruction, link_width));
      }
      ++number;
      frame.begins.push_back(frame.words.size());
    }
  }
  send(isa::FrameEnd{isa::frame_header(program).colour});
  return frame;
}

}  // namespace csgsim::link
