#include "sim/debug/clocks.h"

#include <vector>

#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"

namespace csgsim::debug {

namespace {

/// What a run of the whole Program skips.
std::vector<machines::Skip> skips_of(const isa::Program& program, const machines::Machine& machine) {
  if (!functional::may_skip(program)) return {};
  return engine::make_functional_engine(machine)->run(program, {}).skips;
}

}  // namespace

const machines::Timeline& Clocks::timeline() {
  if (!timeline_) timeline_ = machines::timeline(program_, machine_, skips_of(program_, machine_));
  return *timeline_;
}

machines::ClockSpan Clocks::issued(engine::Place place) { return timeline().issued[place.segment][place.index]; }

std::uint64_t Clocks::first_after(std::uint64_t clock, std::uint64_t from) {
  const engine::Numbers numbers(program_);
  for (; from < numbers.count(); ++from)
    if (issued(numbers.place(from)).end > clock) break;
  return from;
}

}  // namespace csgsim::debug
