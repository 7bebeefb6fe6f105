#include "hw/pixel_square/timing_commands.h"

#include <algorithm>

#include "hw/isa/operands.h"
#include "hw/isa/wire.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

std::vector<TimedCommand> timed_commands(const isa::Program& program, std::size_t square,
                                         const machines::Machine& machine, std::span<const machines::Skip> skips,
                                         machines::Timeline* timeline) {
  const isa::Segment& segment = program.segments[square];
  std::vector<TimedCommand> commands;
  if (segment.instructions.empty()) return commands;
  const std::uint32_t width = command_word_bits(machines::kind_figures<Figures>(machine), machine.link.width);
  commands.reserve(segment.instructions.size() + 2);
  commands.push_back({.kind = CommandKind::start,
                      .words = isa::wire_words(isa::SegmentStart{segment.region}, width),
                      .clocks = std::max<std::uint64_t>(1, machine.clear_clocks),
                      .span = timeline == nullptr ? nullptr : &timeline->cleared[square]});
  for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
    commands.push_back({.kind = CommandKind::instruction,
                        .words = isa::wire_words(segment.instructions[i], width),
                        .clocks = machines::clocks(segment.instructions[i], machine),
                        .span = timeline == nullptr ? nullptr : &timeline->issued[square][i]});
  }
  auto skip = std::ranges::lower_bound(skips, square, {}, &machines::Skip::segment);
  for (; skip != skips.end() && skip->segment == square; ++skip)
    commands[skip->index + 1].skips = isa::skipped_instruction_count(segment.instructions[skip->index], 0);
  commands.push_back({.kind = CommandKind::end,
                      .words = isa::wire_words(isa::SegmentEnd{}, width),
                      .clocks = 1 + std::uint64_t{machines::evaluator_latency(machine)},
                      .region = &segment.region});
  return commands;
}

}  // namespace csgsim::pixel_square
