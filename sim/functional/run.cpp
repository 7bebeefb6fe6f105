#include "sim/functional/run.h"

#include <algorithm>

#include "hw/base/interruption.h"
#include "hw/host/host.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"
#include "hw/machines/runs_on.h"

namespace csgsim::functional {

namespace {

using Instructions = std::span<const isa::Instruction>;
using Observers = std::span<engine::Observer* const>;

}  // namespace

FunctionalRun::FunctionalRun(const isa::Program& program, const machines::Machine& machine, unsigned threads)
    : program_(program), machine_(machine), numbers_(program), tiles_(program, threads), met_(program, machine) {
  machines::check_runs_on(program, machine_);
  if (!program.segments.empty()) tiles_.begin(program.segments.front().region);
}

Instructions FunctionalRun::instructions() const { return program_.segments[place_.segment].instructions; }

bool FunctionalRun::is_finished() const {
  return program_.segments.empty() || (is_end_notified_ && place_.segment + 1 == program_.segments.size());
}

void FunctionalRun::notify_segment_end(Observers observers) {
  if (is_end_notified_) return;
  for (engine::Observer* const observer : observers) observer->after_segment(place_.segment, tiles_);
  is_end_notified_ = true;
}

void FunctionalRun::advance(std::uint64_t number, Observers observers) {
  while (!is_finished()) {
    const std::uint64_t next = numbers_.of(place_);
    if (place_.index < instructions().size()) {
      if (next >= number) return;
      execute_stretch(number - next, observers);
      continue;
    }
    notify_segment_end(observers);
    if (is_finished() || next >= number) return;
    place_ = {place_.segment + 1, 0};
    is_end_notified_ = false;
    tiles_.begin(program_.segments[place_.segment].region);
  }
}

void FunctionalRun::execute_stretch(std::uint64_t max_count, Observers observers) {
  throw_if_interrupted();
  const Instructions left = instructions().subspan(place_.index);
  if (met_.is_needed()) max_count = 1;
  const Instructions within = left.first(static_cast<std::size_t>(std::min<std::uint64_t>(max_count, left.size())));
  const Stretch stretch(within, observers);
  const Instructions executed = stretch.instructions();
  met_.before(place_, executed.front(), tiles_);
  const Tiles::Tally tally = tiles_.execute(stretch);
  met_.after(place_, executed.front(), tiles_);
  overflows_ += tally.overflows;
  for (std::size_t i = 0; i < executed.size(); ++i) {
    const engine::Step step{place_.segment,   place_.index + static_cast<std::uint32_t>(i),
                            executed[i],      machines::clocks(executed[i], machine_),
                            tally.enabled[i], at_pixels()};
    if (step.instruction.opcode == isa::Opcode::global_or) answers_.push_back(step.enabled_pixels != 0);
    for (engine::Observer* const observer : observers)
      if (!stretch.is_observed(i) || !observer->reads_enable_alone(step.instruction))
        observer->after_instruction(step, tiles_);
  }
  place_.index += static_cast<std::uint32_t>(executed.size());
  const std::uint64_t skipped = isa::skipped_instruction_count(executed.back(), tally.enabled.back());
  if (skipped == 0) return;
  skips_.push_back({place_.segment, place_.index - 1});
  skipped_ += skipped;
  place_.index += static_cast<std::uint32_t>(skipped);
}

engine::RunState FunctionalRun::save() const {
  engine::RunState state{place_, is_end_notified_, overflows_, skipped_, answers_, skips_, {}};
  if (!program_.segments.empty()) state.planes = tiles_.planes();
  return state;
}

void FunctionalRun::restore(const engine::RunState& state) {
  met_.jump();
  place_ = state.place;
  is_end_notified_ = state.is_end_reported;
  overflows_ = state.overflows;
  skipped_ = state.skipped;
  answers_ = state.answers;
  skips_ = state.skips;
  if (program_.segments.empty()) return;
  tiles_.begin(program_.segments[place_.segment].region);
  tiles_.load(state.planes);
  if (const isa::Instruction* const squares = isa::pending_squares(program_.segments[place_.segment], place_.index))
    tiles_.execute(Stretch({squares, 1}, {}));
}

/// The clocks of the current instruction at the pixels, if they depend on the pixels.
std::optional<machines::PixelClocks> FunctionalRun::at_pixels() const {
  if (!met_.is_needed()) return std::nullopt;
  const isa::Segment& segment = program_.segments[place_.segment];
  return machine_.kind->clocks_at_pixels(segment, place_.index, machine_, &met_.pixel_activity(place_.segment));
}

/// A run resumed from a saved state lacks the earlier part, so the whole Program is run again.
std::vector<machines::PixelActivity> FunctionalRun::record_pixel_activity() const {
  if (const std::vector<machines::PixelActivity>* const pixel_activity = met_.pixel_activity()) return *pixel_activity;
  FunctionalRun whole(program_, machine_, 1);
  whole.advance(end, {});
  return whole.record_pixel_activity();
}

engine::RunResult FunctionalRun::result() const {
  engine::RunResult result;
  result.overflows = overflows_;
  result.skipped = skipped_;
  result.skips = skips_;
  result.answers = answers_;
  result.work = tiles_.work();
  result.pixel_activity = record_pixel_activity();
  put(host::time_frame(program_, machine_, engine::run_outcome(result)), result);
  return result;
}

}  // namespace csgsim::functional
