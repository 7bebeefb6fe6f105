#include <utility>

#include "hw/machines/clocks.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/timing.h"
#include "sim/reference/reference_array.h"

namespace csgsim::sim {

namespace {

class ReferenceEngine final : public Engine {
 public:
  explicit ReferenceEngine(machines::Machine machine) : machine_(std::move(machine)) {}

  [[nodiscard]] std::string_view level() const override { return "reference"; }

  RunResult run(const isa::Program& program, std::span<Observer* const> observers) override {
    machines::check_runs_on(program, machine_);
    RunResult result;
    for (std::size_t s = 0; s < program.segments.size(); ++s) run_segment(program, s, observers, result);
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
  void run_segment(const isa::Program& program, std::size_t s, std::span<Observer* const> observers,
                   RunResult& result) const {
    const isa::Segment& segment = program.segments[s];
    const auto number = static_cast<std::uint32_t>(s);
    ReferenceArray array(segment.region, program.shape.memory_bits);
    for (std::size_t index = 0; index < segment.instructions.size(); ++index) {
      const isa::Instruction& instruction = segment.instructions[index];
      const std::uint64_t enabled = array.enabled_pixels();
      const std::uint64_t clocks = machines::clocks(instruction, machine_);
      array.execute(instruction);
      result.clocks += clocks;
      if (instruction.opcode == isa::Opcode::global_or) result.answers.push_back(enabled > 0);
      const Step step{number, static_cast<std::uint32_t>(index), instruction, clocks, enabled};
      for (Observer* observer : observers) observer->after_instruction(step, array);
      if (instruction.opcode == isa::Opcode::skip_if_none && enabled == 0) {
        index += instruction.constant;
        result.skipped += instruction.constant;
      }
    }
    result.overflows += array.overflows();
    for (Observer* observer : observers) observer->after_segment(number, array);
  }

  machines::Machine machine_;
};

}  // namespace

std::unique_ptr<Engine> make_reference_engine(const machines::Machine& machine) {
  return std::make_unique<ReferenceEngine>(machine);
}

}  // namespace csgsim::sim
