#include "hw/pixel_square/commands.h"

#include "hw/isa/wire.h"

namespace csgsim::pixel_square {

std::vector<isa::LinkWord> encode_square(const isa::Region& region, std::span<const isa::Instruction> instructions,
                                         std::uint32_t link_width) {
  std::vector<isa::LinkWord> words;
  if (instructions.empty()) return words;
  const auto add = [&](const isa::LinkWord& word) { words.push_back(word); };
  isa::encode(isa::SegmentStart{region}, link_width, add);
  for (const isa::Instruction& instruction : instructions) isa::encode(instruction, link_width, add);
  isa::encode(isa::SegmentEnd{}, link_width, add);
  return words;
}

}  // namespace csgsim::pixel_square
