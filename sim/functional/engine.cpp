#include "sim/engine/engine.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "hw/machines/clocks.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"
#include "sim/functional/bands.h"

namespace csgsim::sim {

namespace {

/// Instructions until one, inclusive, after which an observer looks at the pixels; few enough to show progress.
std::size_t unread_stretch(std::span<const isa::Instruction> instructions, std::span<Observer* const> observers) {
  constexpr std::size_t most = 1024;
  std::size_t count = 0;
  while (count < std::min(most, instructions.size())) {
    const isa::Instruction& instruction = instructions[count++];
    if (std::any_of(observers.begin(), observers.end(),
                    [&](const Observer* one) { return one->reads_after(instruction); })) {
      break;
    }
  }
  return count;
}

class FunctionalEngine final : public Engine {
 public:
  FunctionalEngine(machines::Machine machine, unsigned threads) : machine_(std::move(machine)), threads_(threads) {
    if (threads == 0) throw std::invalid_argument("no thread to run on");
  }

  [[nodiscard]] std::string_view level() const override { return "functional"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    RunResult result;
    Bands bands(program, threads_);
    for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
      bands.begin(program.segments[s].region);
      const std::span<const isa::Instruction> all = program.segments[s].instructions;
      for (std::size_t begin = 0; begin < all.size();) {
        const std::span<const isa::Instruction> stretch =
            all.subspan(begin, unread_stretch(all.subspan(begin), observers));
        const Bands::Tally tally = bands.execute(stretch);
        result.overflows += tally.overflows;
        for (std::size_t i = 0; i < stretch.size(); ++i) {
          const Step step{s, static_cast<std::uint32_t>(begin + i), stretch[i], machines::clocks(stretch[i], machine_),
                          tally.enabled[i]};
          result.clocks += step.clocks;
          if (step.instruction.opcode == isa::Opcode::global_or) result.answers.push_back(step.enabled_pixels != 0);
          for (Observer* const observer : observers) observer->after_instruction(step, bands);
        }
        begin += stretch.size();
      }
      for (Observer* const observer : observers) observer->after_segment(s, bands);
    }
    if (machine_.kind != machines::Kind::frame_buffer) {
      machines::FrameTiming timing = machines::time_frame(program, machine_);
      result.clocks = timing.clocks;
      result.account = std::move(timing.account);
      return result;
    }
    result.latency_clocks = machines::evaluator_latency(machine_.array);
    result.clocks += result.latency_clocks;
    return result;
  }

 private:
  machines::Machine machine_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Engine> make_functional_engine(const machines::Machine& machine, unsigned threads) {
  return std::make_unique<FunctionalEngine>(machine, threads);
}

}  // namespace csgsim::sim
