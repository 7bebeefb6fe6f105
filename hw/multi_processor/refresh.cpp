#include "hw/multi_processor/refresh.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::multi_processor {

namespace {

/// Holds products of two rates.
__extension__ using Wide = unsigned __int128;

}  // namespace

Refresh::Refresh(const isa::FrameHeader& header, const machines::Machine& machine)
    : clock_hz_(machine.clock_hz), turn_clocks_(machines::kind_figures<Figures>(machine).refresh.clocks) {
  const RefreshFigures& figures = machines::kind_figures<Figures>(machine).refresh;
  const std::uint64_t pixels = std::uint64_t{quotient_up(header.shape.width, machine.array.width)} *
                               quotient_up(header.shape.height, machine.array.height);
  turns_per_second_ = figures.rate * quotient_up(pixels * header.colour.width, std::uint64_t{figures.bits});
}

/// Number of clocks before `clock` that do not belong to a turn.
std::uint64_t Refresh::free_clocks_until(std::uint64_t clock) const {
  if (turns_per_second_ == 0 || clock == 0) return clock;
  const auto turns = static_cast<std::uint64_t>(Wide{clock - 1} * turns_per_second_ / clock_hz_);
  if (turns == 0) return clock;
  const auto last = static_cast<std::uint64_t>((Wide{turns} * clock_hz_ + turns_per_second_ - 1) / turns_per_second_);
  return clock - (turns - 1) * turn_clocks_ - std::min(turn_clocks_, clock - last);
}

std::uint64_t Refresh::end_clock(std::uint64_t begin_clock, std::uint64_t work_clocks) const {
  if (turns_per_second_ == 0 || work_clocks == 0) return begin_clock + work_clocks;
  const std::uint64_t required = free_clocks_until(begin_clock) + work_clocks;
  std::uint64_t end = begin_clock + work_clocks;
  // No omitted clock is counted twice, so the loop stops at the first end with enough free work_clocks.
  for (std::uint64_t free = free_clocks_until(end); free < required; free = free_clocks_until(end))
    end += required - free;
  return end;
}

void check_refresh(const isa::FrameHeader& header, const machines::Machine& machine) {
  const std::uint64_t turns = Refresh(header, machine).turns_per_second();
  const std::uint32_t clocks = machines::kind_figures<Figures>(machine).refresh.clocks;
  if (turns == 0 || turns <= (machine.clock_hz - 1) / clocks) return;
  throw InputError(fmt::format(
      "the screen takes {} turns per second of {} clocks each, but the memories of {} have {} clocks per second, "
      "which leaves none for drawing; increase refresh.bits",
      turns, clocks, machine.name, machine.clock_hz));
}

}  // namespace csgsim::multi_processor
