#include "hw/machines/timeline.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "hw/base/error.h"
#include "hw/machines/kind.h"

namespace csgsim::machines {

Timeline timeline(const isa::Program& program, const Machine& machine, const RunOutcome& outcome) {
  std::optional<Timeline> found = machine.kind->timeline(program, machine, outcome);
  if (!found) {
    throw InputError(fmt::format("machines of the kind {} provide no instruction timeline; use another --machine",
                                 machine.kind->name));
  }

  return std::move(*found);
}

std::vector<ClockSpan> spans_at_pixel(const Timeline& timeline, const isa::Program& program, const Machine& machine,
                                      std::uint32_t segment, std::uint32_t x, std::uint32_t y) {
  return machine.kind->spans_at_pixel(timeline, program, machine, segment, x, y);
}

Timeline blank_timeline(const isa::Program& program) {
  Timeline blank;
  blank.cleared.resize(program.segments.size());
  for (const isa::Segment& segment : program.segments) blank.issued.emplace_back(segment.instructions.size());
  return blank;
}

std::vector<ClockSpan> shifted(std::vector<ClockSpan> spans, std::uint64_t clocks) {
  for (ClockSpan& span : spans) {
    if (span.end > 0) span = {span.begin + clocks, span.end + clocks};
  }
  return spans;
}

}  // namespace csgsim::machines
