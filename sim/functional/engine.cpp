#include "sim/engine/engine.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"
#include "sim/functional/bands.h"

namespace csgsim::sim {

namespace {

using Instructions = std::span<const isa::Instruction>;
using Observers = std::span<Observer* const>;

/// Instructions until one, inclusive, after which an observer looks at the pixels or some may be skipped; few enough to
/// show progress.
std::size_t unread_stretch(Instructions instructions, Observers observers) {
  constexpr std::size_t most = 1024;
  std::size_t count = 0;
  while (count < std::min(most, instructions.size())) {
    const isa::Instruction& instruction = instructions[count++];
    if (instruction.opcode == isa::Opcode::skip_if_none) break;
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

  RunResult run(const isa::Program& program, Observers observers) override {
    machines::check_runs_on(program, machine_);
    RunResult result;
    Bands bands(program, threads_);
    std::vector<machines::Skip> skips;
    for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
      bands.begin(program.segments[s].region);
      run_segment(program.segments[s].instructions, s, bands, observers, result, skips);
      for (Observer* const observer : observers) observer->after_segment(s, bands);
    }
    put(machines::time_frame(program, machine_, skips), result);
    return result;
  }

 private:
  void run_segment(Instructions all, std::uint32_t segment, Bands& bands, Observers observers, RunResult& result,
                   std::vector<machines::Skip>& skips) const {
    for (std::size_t begin = 0; begin < all.size();) {
      const Instructions stretch = all.subspan(begin, unread_stretch(all.subspan(begin), observers));
      const Bands::Tally tally = bands.execute(stretch);
      result.overflows += tally.overflows;
      for (std::size_t i = 0; i < stretch.size(); ++i) {
        const Step step{segment, static_cast<std::uint32_t>(begin + i), stretch[i],
                        machines::clocks(stretch[i], machine_), tally.enabled[i]};
        if (step.instruction.opcode == isa::Opcode::global_or) result.answers.push_back(step.enabled_pixels != 0);
        for (Observer* const observer : observers) observer->after_instruction(step, bands);
      }
      const std::uint64_t skipped = isa::skipped_after(stretch.back(), tally.enabled.back());
      result.skipped += skipped;
      if (skipped > 0) skips.push_back({segment, static_cast<std::uint32_t>(begin + stretch.size() - 1)});
      begin += stretch.size() + skipped;
    }
  }

  machines::Machine machine_;
  unsigned threads_;
};

}  // namespace

std::unique_ptr<Engine> make_functional_engine(const machines::Machine& machine, unsigned threads) {
  return std::make_unique<FunctionalEngine>(machine, threads);
}

}  // namespace csgsim::sim
