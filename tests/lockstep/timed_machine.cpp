#include "tests/lockstep/timed_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <systemc>
#include <tuple>

#include "hw/isa/opcodes.h"
#include "hw/machines/timeline.h"
#include "hw/systemc/kernel.h"
#include "hw/wave/vcd_writer.h"
#include "sim/cycle/clocked_engine.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/wave_check.h"

namespace csgsim::test {

/// Records retired instructions and forwards every event.
class TimedMachine::Listener final : public systemc::RunListener {
 public:
  Listener(TimedMachine& machine, systemc::RunListener& next) : machine_(machine), next_(next) {}

  [[nodiscard]] systemc::Keep required_after(std::uint32_t segment, std::uint32_t index) override {
    return next_.required_after(segment, index);
  }
  void after_instruction(const systemc::Retired& retired, const systemc::PixelView& pixels) override {
    machine_.retired_.push_back({retired.segment, retired.index, machine_.edges()});
    if (retired.skipped > 0) machine_.skips_.push_back({retired.segment, retired.index});
    next_.after_instruction(retired, pixels);
  }
  void after_segment(std::uint32_t segment, const systemc::PixelView& pixels) override {
    next_.after_segment(segment, pixels);
  }

 private:
  TimedMachine& machine_;
  systemc::RunListener& next_;
};

TimedMachine::TimedMachine(const machines::Machine& machine, systemc::EvaluatorForm form)
    : machine_(machine),
      hardware_(cycle::clocked_hardware(machine, form)),
      recorder_("wave", systemc::period_of(machine)) {}

std::uint64_t TimedMachine::edges() const {
  return sc_core::sc_time_stamp().value() / systemc::period_of(machine_).value();
}

systemc::RunReport TimedMachine::run(const isa::Program& program, systemc::RunListener& listener) {
  retired_.clear();
  skips_.clear();
  Listener timed(*this, listener);
  const std::uint64_t before = edges();
  systemc::RunReport report = hardware_.run(program, timed);
  for (Retirement& one : retired_) one.edge -= before;
  return report;
}

void TimedMachine::check_wave(const isa::Program& program, engine::Engine& judge) {
  constexpr std::uint64_t period = 1000;
  const bool has_instructions =
      std::ranges::any_of(program.segments, [](const isa::Segment& segment) { return !segment.instructions.empty(); });
  if (!has_instructions) return;
  const WaveCheck wave(program, machine_, judge);
  std::string dump;
  const wave::Request request = wave.request([&dump](std::string_view text) { dump += text; });
  recorder_.arm(
      std::make_unique<wave::VcdWriter>("machine", hardware_.taps(wave.program(), request), period, request.write),
      request.windows, 0, false);
  systemc::RunListener nobody;
  hardware_.run(wave.program(), nobody);
  if (recorder_.finish()) wave.check(Vcd(dump), "machine", period);
}

void TimedMachine::check_timeline(const isa::Program& program) const {
  std::vector<machines::Skip> skips = skips_;
  std::ranges::sort(skips, {}, [](const machines::Skip& one) { return std::tuple(one.segment, one.index); });
  const machines::Timeline timeline = machines::timeline(program, machine_, skips);
  std::size_t carried_out = 0;
  for (const auto& spans : timeline.issued)
    carried_out += static_cast<std::size_t>(std::ranges::count_if(spans, [](const auto& one) { return one.end > 0; }));
  if (carried_out != retired_.size())
    throw Difference(fmt::format("the timeline has {} instructions, {} retired", carried_out, retired_.size()));
  std::vector<std::vector<machines::ClockSpan>> at_last_pixel;
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const isa::Region& region = program.segments[s].region;
    at_last_pixel.push_back(machines::spans_at_pixel(timeline, program, machine_, s, region.x + region.width - 1,
                                                     region.y + region.height - 1));
  }
  for (const Retirement& one : retired_) {
    const isa::Opcode opcode = program.segments[one.segment].instructions[one.index].opcode;
    const auto& spans = isa::needs_global_or(opcode) ? timeline.issued : at_last_pixel;
    const std::uint64_t expected = spans[one.segment][one.index].end;
    const std::uint64_t clock = one.edge - 1;
    if (clock == expected) continue;
    throw Difference(fmt::format("segment {}, instruction {} ({}): retired in clock {}, in the timeline in {}",
                                 one.segment, one.index, isa::name_of(opcode), clock, expected));
  }
}

}  // namespace csgsim::test
