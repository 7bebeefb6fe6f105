#include "sim/story/story.h"

#include <algorithm>
#include <optional>
#include <span>

#include "hw/isa/facts.h"
#include "hw/isa/instruction_numbers.h"
#include "hw/machines/kind.h"
#include "hw/machines/runs_on.h"
#include "sim/functional/clocks.h"
#include "sim/story/events.h"
#include "sim/story/pixel_run.h"

namespace csgsim::story {

namespace {

/// The clocks from the beginning of the event's first instruction to the end of its last. `clocks` are those of the
/// segment's instructions at the pixel.
machines::ClockSpan clocks_of(const Event& event, std::uint64_t first_number,
                              const std::vector<machines::ClockSpan>& clocks) {
  if (event.kind == EventKind::skip) return {};
  return {clocks[static_cast<std::size_t>(event.first - first_number)].begin,
          clocks[static_cast<std::size_t>(event.last - first_number)].end};
}

}  // namespace

const Change* Event::change_of(const isa::Program& program, isa::FieldRole role) const {
  for (const Change& change : changes) {
    const bool has_role =
        std::any_of(program.facts->fields.begin(), program.facts->fields.end(),
                    [&](const isa::NamedField& named) { return named.role == role && named.field == change.field; });
    if (has_role) return &change;
  }
  return nullptr;
}

namespace {

const isa::Program& checked(const isa::Program& program, const machines::Machine& machine) {
  machines::check_runs_on(program, machine);
  return program;
}

}  // namespace

StoryBuilder::StoryBuilder(const isa::Program& program, const machines::Machine& machine)
    : program_(checked(program, machine)),
      machine_(machine),
      first_numbers_(isa::first_instruction_numbers(program)),
      record_(functional::make_run_record(program, machine)),
      timeline_(machine.kind->timeline(program, machine, record_.outcome())) {}

Story StoryBuilder::story_of(std::uint32_t x, std::uint32_t y) const {
  const PixelRun run = run_pixel(program_, record_.skips, x, y);
  Story story;
  story.x = x;
  story.y = y;
  story.owner = run.nearest.owner;
  story.depth = run.nearest.depth;
  story.opaque_owner = run.opaque.owner;
  story.opaque_depth = run.opaque.depth;
  story.colour = run.colour;
  story.events = find_events(program_, run, first_numbers_);
  for (const std::uint32_t segment : run.segments) {
    story.segments.push_back({segment, first_numbers_[segment], first_numbers_[segment + 1]});
    if (!timeline_) continue;
    const std::vector<machines::ClockSpan> clocks =
        machines::spans_at_pixel(*timeline_, program_, machine_, segment, x, y);
    for (Event& event : story.events)
      if (event.segment == segment) event.clocks = clocks_of(event, first_numbers_[segment], clocks);
  }
  story.attempts = find_attempts(program_, story.events, story.owner);
  return story;
}

}  // namespace csgsim::story
