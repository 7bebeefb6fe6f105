#include <algorithm>

#include "hw/bit_serial_memory/timing.h"

namespace csgsim::bit_serial_memory {

RankTiming::RankTiming(const Figures& figures, const Slots& slots)
    : figures_(figures), slots_(slots), due_(figures.rank.refresh_interval), free_(slots.used_banks()) {}

void RankTiming::start(std::uint64_t clock) {
  start_ = clock;
  std::ranges::fill(free_, clock);
  allowed_.fill(clock);
  last_ = clock;
  bus_ = clock;
}

std::uint64_t RankTiming::clocks(const RowCommands& commands) {
  start(0);
  refreshes_come_ = false;
  for (const RowCommand& command : commands) issue_to_all(command);
  return over();
}

std::uint64_t RankTiming::carry_out(const RowCommands& commands, std::uint64_t begin) {
  start(begin);
  refreshes_come_ = figures_.rank.refresh_interval > 0;
  for (const RowCommand& command : commands) {
    refresh_before(command);
    issue_to_all(command);
  }
  return over();
}

std::uint64_t RankTiming::begin(std::uint64_t free, std::uint64_t ready) {
  while (figures_.rank.refresh_interval > 0 && due_ <= std::max(free, ready)) {
    free = std::max(free, due_) + figures_.rank.refresh;
    due_ += figures_.rank.refresh_interval;
    refreshing_ += figures_.rank.refresh;
    ++refreshes_;
  }
  return std::max(free, ready);
}

std::uint64_t RankTiming::next_activation(std::uint64_t bank) const {
  return std::max({free_[bank], last_, allowed_[next_]});
}

void RankTiming::activate(std::uint64_t clock) {
  last_ = clock + figures_.rank.activation_gap;
  allowed_[next_] = clock + figures_.rank.window;
  next_ = (next_ + 1) % allowed_.size();
}

void RankTiming::refresh_before(const RowCommand& command) {
  if (!refreshes_come_ || !begins_closed(command.op)) return;
  const std::uint64_t now = next_activation(0);
  if (now < due_) return;
  std::uint64_t taken = std::max({now, bus_, *std::ranges::max_element(free_)}) - now;
  while (due_ <= now + taken) {
    taken += figures_.rank.refresh;
    due_ += figures_.rank.refresh_interval;
    ++refreshes_;
  }
  shift(taken);
  refreshing_ += taken;
}

void RankTiming::shift(std::uint64_t clocks) {
  for (std::uint64_t& bank : free_) bank += clocks;
  for (std::uint64_t& one : allowed_) one += clocks;
  last_ += clocks;
  bus_ += clocks;
}

void RankTiming::issue_to_all(const RowCommand& command) {
  const CommandClocks& clocks = figures_.command;
  if (activations(command.op) > 0) {
    for (std::uint64_t slot = 0; slot < slots_.count(); ++slot) issue(command, slot);
    return;
  }
  const std::uint64_t taken = command.op == RowOp::logic  ? clocks.logic
                              : command.op == RowOp::leaf ? std::max(clocks.logic, clocks.leaf)
                                                          : clocks.global_or;
  for (std::uint64_t& bank : free_) bank += taken;
}

void RankTiming::issue(const RowCommand& command, std::uint64_t slot) {
  const CommandClocks& clocks = figures_.command;
  std::uint64_t& free = free_[slots_.bank(slot)];
  const std::uint64_t first = next_activation(slots_.bank(slot));
  activate(first);
  switch (command.op) {
    case RowOp::copy: {
      const std::uint64_t second = std::max({first + clocks.second, last_, allowed_[next_]});
      activate(second);
      free = second + clocks.restore + clocks.precharge;
      return;
    }
    case RowOp::leaf_copy:
      free = first + std::max<std::uint64_t>(clocks.restore + clocks.precharge, clocks.leaf);
      return;
    case RowOp::receive:
    case RowOp::send:
      bus_ = std::max(bus_, first + clocks.column) + transfer_clocks(slots_.columns(slot), figures_);
      free = std::max(first + clocks.restore, bus_ + clocks.recovery) + clocks.precharge;
      return;
    case RowOp::activate:
    case RowOp::latch:
    case RowOp::read:
    case RowOp::write: free = first + clocks.restore + clocks.precharge; return;
    case RowOp::logic:
    case RowOp::leaf:
    case RowOp::wired_or: return;
  }
}

std::uint64_t RankTiming::over() const {
  const std::uint64_t closed = *std::ranges::max_element(free_);
  return std::max({start_, closed, bus_, last_, *std::ranges::max_element(allowed_)});
}

}  // namespace csgsim::bit_serial_memory
