#include <algorithm>
#include <optional>
#include <vector>

#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"

namespace csgsim::machines {

namespace {

/// A chain as the lines that it has been given leave it.
struct ChainTiming {
  std::uint64_t clocks = 0;                ///< until the last mark has entered
  std::optional<std::uint64_t> last_mark;  ///< the clock in which it was in cell 0
};

std::uint64_t words_of(const isa::Segment& segment, const Machine& machine) {
  std::uint64_t words = 0;
  for (const isa::Instruction& instruction : segment.instructions) words += packet_words(instruction, machine);
  return words;
}

/// Of the packet, or the mark of a line without any.
std::uint64_t first_words(const isa::Segment& segment, const Machine& machine) {
  return segment.instructions.empty() ? 1 : packet_words(segment.instructions.front(), machine);
}

}  // namespace

std::uint64_t line_budget(const Machine& machine, std::uint32_t picture_height) {
  const ScanLine& scan_line = machine.scan_line;
  const std::uint64_t field_lines = scan_line.interlaced ? (picture_height + 1ULL) / 2 : picture_height;
  return scan_line.chains * (machine.clock_hz / (scan_line.refresh_hz * field_lines));
}

FrameTiming time_lines(const isa::Program& program, const Machine& machine) {
  const std::uint64_t interval = machine.scan_line.packet_interval;
  const std::uint64_t pixels = program.shape.width;
  LineAccount account{.lines = program.segments.size(), .line_budget = line_budget(machine, program.shape.height)};
  std::vector<ChainTiming> chains(machine.scan_line.chains);
  for (std::size_t line = 0; line < program.segments.size(); ++line) {
    const isa::Segment& segment = program.segments[line];
    ChainTiming& chain = chains[line % chains.size()];
    const std::uint64_t words = words_of(segment, machine);
    const std::uint64_t entry = (words + 1) * interval;
    if (!chain.last_mark) {
      const std::uint64_t fill = first_words(segment, machine) * interval + pixels - 1;
      account.fill_clocks = line == 0 ? fill : std::min(account.fill_clocks, fill);
    }
    const std::uint64_t asked = chain.clocks + entry - 1;
    const std::uint64_t mark =
        chain.last_mark ? std::max(asked, *chain.last_mark + mark_spacing(program.shape.width)) : asked;
    chain = {.clocks = mark + 1, .last_mark = mark};

    account.packets += segment.instructions.size();
    account.most_packets = std::max<std::uint64_t>(account.most_packets, segment.instructions.size());
    account.late_lines += entry > account.line_budget ? 1 : 0;
    account.entry_clocks += entry;
    account.refresh_clocks += mark - asked;
    account.busy_cells += words * pixels;
  }
  // Through the cells, and through the shift chain.
  account.drain_clocks = 2 * pixels;
  std::uint64_t clocks = 0;
  for (const ChainTiming& chain : chains) clocks = std::max(clocks, chain.clocks + account.drain_clocks);
  return {clocks, account};
}

}  // namespace csgsim::machines
