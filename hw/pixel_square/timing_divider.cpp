#include "hw/pixel_square/timing_divider.h"

#include <utility>

#include "hw/isa/host_counts.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/timing_commands.h"

namespace csgsim::pixel_square {

DividerTiming::DividerTiming(const isa::Program& program, const machines::Machine& machine, std::size_t part,
                             std::size_t sender, Agenda& agenda, machines::Timeline* timeline)
    : program_(program),
      machine_(machine),
      division_(program, machine),
      part_(part),
      agenda_(&agenda),
      timeline_(timeline),
      store_(machines::kind_figures<Figures>(machine).store_words, part, sender, agenda) {}

void DividerTiming::begin(Time now, std::uint64_t model_words) {
  clocks_.count_working(model_words);
  clocks_.count_waiting(SquareActivity::waiting_for_host, now + 1);
  before_ = division_.tree_clocks();
  schedule_next(now);
}

/// Lists the words stored for a square and the tests between them. The first square of a group includes the group's
/// tests.
void DividerTiming::list_pieces(std::size_t square) {
  const isa::Segment& segment = program_.segments[square];
  const isa::DivisionCounts& counts = *segment.division;
  const bool is_first = counts.group_boxes > 0 || counts.group_entries > 0;
  if (is_first) {
    before_ += division_.group_clocks(counts);
    from_list_ = division_.is_listed(counts.group_entries);
  }
  const std::vector<TimedCommand> commands = timed_commands(program_, square, machine_, {}, timeline_);
  const auto store = [&](const TimedCommand& command, std::uint64_t clocks) {
    pieces_.push_back({std::exchange(before_, 0) + clocks, command.words, {command, false}});
  };
  std::size_t instruction = 0;
  for (const isa::DivisionStep& step : counts.steps) {
    before_ += division_.test_clocks(step, from_list_);
    for (std::uint64_t i = 0; i < step.instructions; ++i, ++instruction) {
      // SegmentStart is written to the store together with the first instruction.
      const std::uint64_t clocks = division_.instruction_clocks(segment.instructions[instruction]);
      if (instruction > 0) {
        store(commands[instruction + 1], clocks);
        continue;
      }
      before_ += clocks;
      store(commands.front(), 0);
      store(commands[1], 0);
    }
  }
  if (commands.empty()) {
    pieces_.push_back({std::exchange(before_, 0), 1, {std::nullopt, true}});
  } else {
    store(commands.back(), 0);
    pieces_.back().last.is_last = true;
  }
}

/// Starts the next piece after one that was complete at edge `now`.
void DividerTiming::schedule_next(Time now) {
  if (pieces_.empty()) {
    if (assigned_.empty()) return;
    list_pieces(assigned_.front());
    assigned_.pop_front();
  }
  stored_ = 0;
  const Time until = pieces_.front().clocks + 1;
  clocks_.count_working(until);
  agenda_->schedule(part_, now + until);
}

void DividerTiming::act(Time now) {
  if (pieces_.empty()) return;
  if (!store_.has_room(now)) {
    if (store_.has_room_next()) agenda_->schedule(part_, now + 1);
    return;
  }
  clocks_.count_waiting(SquareActivity::waiting_for_renderer, now + 1);
  const Piece& piece = pieces_.front();
  const bool is_last = ++stored_ == piece.words;
  store_.write(now, is_last ? piece.last : TimedStored{});
  if (is_last) {
    pieces_.pop_front();
    return schedule_next(now);
  }
  clocks_.count_working(1);
  agenda_->schedule(part_, now + 1);
}

}  // namespace csgsim::pixel_square
