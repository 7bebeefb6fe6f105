#include <algorithm>

#include "hw/bit_serial_memory/timing.h"

namespace csgsim::bit_serial_memory {

RankTiming::RankTiming(const Figures& figures, const Slots& slots, RowListener* listener)
    : rank_(figures.rank), steps_(figures, slots), listener_(listener), due_(figures.rank.refresh_interval) {}

std::uint64_t RankTiming::clocks(const RowCommands& commands) {
  steps_.start(0);
  for (const RowCommand& command : commands) steps_.step(command.op);
  return steps_.over();
}

std::uint64_t RankTiming::carry_out(const RowCommands& commands, std::uint64_t begin) {
  steps_.start(begin);
  for (const RowCommand& command : commands) {
    if (rank_.refresh_interval > 0 && begins_closed(command.op)) refresh_if_due();
    step(command);
  }
  return steps_.over();
}

void RankTiming::step(const RowCommand& command) {
  if (listener_ == nullptr) return steps_.step(command.op);
  issues_.clear();
  steps_.step(command, issues_);
  listener_->command(command, issues_);
}

std::uint64_t RankTiming::begin(std::uint64_t free, std::uint64_t ready) {
  while (rank_.refresh_interval > 0 && due_ <= std::max(free, ready)) {
    const std::uint64_t clock = std::max(free, due_);
    free = clock + rank_.refresh;
    refreshing_ += rank_.refresh;
    count_refresh(clock);
  }
  return std::max(free, ready);
}

/// Counts a refresh that begins at `clock`.
void RankTiming::count_refresh(std::uint64_t clock) {
  due_ += rank_.refresh_interval;
  ++refreshes_;
  if (listener_ != nullptr) listener_->refresh(clock);
}

void RankTiming::refresh_if_due() {
  const std::uint64_t now = steps_.next_activation();
  if (now < due_) return;
  std::uint64_t taken = steps_.closed() - now;
  while (due_ <= now + taken) {
    const std::uint64_t clock = now + taken;
    taken += rank_.refresh;
    count_refresh(clock);
  }
  steps_.delay(taken);
  refreshing_ += taken;
}

}  // namespace csgsim::bit_serial_memory
