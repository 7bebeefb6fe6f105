#include "sim/debug/clocks.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "hw/isa/opcodes.h"
#include "sim/engine/run.h"

namespace csgsim::debug {

namespace {

/// What a run of the whole Program skips.
std::vector<machines::Skip> skips_of(const isa::Program& program, const machines::Machine& machine) {
  const auto asks = [](const isa::Segment& segment) {
    return std::any_of(segment.instructions.begin(), segment.instructions.end(),
                       [](const isa::Instruction& one) { return one.opcode == isa::Opcode::skip_if_none; });
  };
  if (std::none_of(program.segments.begin(), program.segments.end(), asks)) return {};
  const std::unique_ptr<engine::Engine> engine = engine::make_functional_engine(machine);
  const std::unique_ptr<engine::Run> run = engine->begin(program);
  run->advance(engine::Run::end, {});
  return run->save().skips;
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
