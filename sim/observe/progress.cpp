#include "sim/observe/progress.h"

#include <fmt/format.h>

#include <span>

#include "hw/base/messages.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"

namespace csgsim::observe {

namespace {

/// Instructions between two reads of the clock.
constexpr std::uint64_t look_every = 64;

}  // namespace

ProgressObserver::ProgressObserver(const isa::Program& program, const machines::Machine& machine)
    : program_(program), machine_(machine) {
  for (const isa::Segment& segment : program.segments) total_ += machines::clocks(segment.instructions, machine);
}

void ProgressObserver::begin_at(engine::Place place) {
  for (std::uint32_t segment = 0; segment <= place.segment && segment < program_.segments.size(); ++segment) {
    const std::span<const isa::Instruction> all = program_.segments[segment].instructions;
    total_ -= machines::clocks(segment < place.segment ? all : all.first(place.index), machine_);
  }
}

void ProgressObserver::warn(LongWork& work, bool shows_progress) {
  work_ = &work;
  shows_ = shows_progress;
}

ProgressObserver::~ProgressObserver() {
  if (shown_) write_message("\r\x1b[K");
}

void ProgressObserver::after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) {
  done_ += step.clocks;
  if (const std::uint64_t skipped = isa::skipped_instruction_count(step.instruction, step.enabled_pixels);
      skipped > 0) {
    const std::span<const isa::Instruction> all = program_.segments[step.segment].instructions;
    total_ -= machines::clocks(all.subspan(step.index + 1, static_cast<std::size_t>(skipped)), machine_);
  }
  if (++instructions_ % look_every != 0) return;
  if (work_ != nullptr && work_->elapsed() >= 1.0)
    work_->record_fraction(static_cast<double>(done_) / static_cast<double>(total_));
  if (!shows_) return;
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> since_shown = now - last_shown_;
  const std::chrono::duration<double> elapsed = now - begin_;
  if (elapsed.count() < 1.0 || since_shown.count() < 0.25) return;
  last_shown_ = now;
  shown_ = true;
  const double rate = static_cast<double>(done_) / elapsed.count();
  const double left = static_cast<double>(total_ - done_) / rate;
  const double percent = 100.0 * static_cast<double>(done_) / static_cast<double>(total_);
  write_message(fmt::format("\r\x1b[K{:5.1f} %  {} of {} clocks  {:.0f} clocks/s  {:.0f} s left", percent, done_,
                            total_, rate, left));
}

}  // namespace csgsim::observe
