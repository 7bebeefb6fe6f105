#include <algorithm>

#include "hw/bit_serial_memory/timing.h"

namespace csgsim::bit_serial_memory {

RankTiming::RankTiming(const Figures& figures, const Slots& slots)
    : rank_(figures.rank), steps_(figures, slots), due_(figures.rank.refresh_interval) {}

std::uint64_t RankTiming::clocks(const RowCommands& commands) {
  steps_.start(0);
  for (const RowCommand& command : commands) steps_.step(command.op);
  return steps_.over();
}

std::uint64_t RankTiming::carry_out(const RowCommands& commands, std::uint64_t begin) {
  steps_.start(begin);
  for (const RowCommand& command : commands) {
    if (rank_.refresh_interval > 0 && begins_closed(command.op)) refresh_if_due();
    steps_.step(command.op);
  }
  return steps_.over();
}

std::uint64_t RankTiming::begin(std::uint64_t free, std::uint64_t ready) {
  while (rank_.refresh_interval > 0 && due_ <= std::max(free, ready)) {
    free = std::max(free, due_) + rank_.refresh;
    due_ += rank_.refresh_interval;
    refreshing_ += rank_.refresh;
    ++refreshes_;
  }
  return std::max(free, ready);
}

void RankTiming::refresh_if_due() {
  const std::uint64_t now = steps_.next_activation();
  if (now < due_) return;
  std::uint64_t taken = steps_.closed() - now;
  while (due_ <= now + taken) {
    taken += rank_.refresh;
    due_ += rank_.refresh_interval;
    ++refreshes_;
  }
  steps_.delay(taken);
  refreshing_ += taken;
}

}  // namespace csgsim::bit_serial_memory
