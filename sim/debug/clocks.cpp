#include "sim/debug/clocks.h"

#include "sim/functional/clocks.h"

namespace csgsim::debug {

const machines::Timeline& Clocks::timeline() {
  if (!timeline_)
    timeline_ = machines::timeline(program_, machine_, functional::make_run_record(program_, machine_).outcome());
  return *timeline_;
}

machines::ClockSpan Clocks::issue_span(engine::Place place) { return timeline().issued[place.segment][place.index]; }

std::uint64_t Clocks::first_not_issued(std::uint64_t clock, std::uint64_t first_number) {
  const engine::Numbers numbers(program_);
  for (; first_number < numbers.count(); ++first_number)
    if (issue_span(numbers.place(first_number)).end > clock) break;
  return first_number;
}

}  // namespace csgsim::debug
